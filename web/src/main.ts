// Starts the pages.

import "./styles/tokens.css";
import "./styles/base.css";
import "./styles/print.css";
import "./styles/touch.css";
import { mount } from "svelte";
import App from "./App.svelte";
import { theme } from "./state/theme.svelte";
import { i18n } from "./texts/i18n.svelte";

theme.apply();
document.documentElement.lang = i18n.lang;
mount(App, { target: document.getElementById("app")! });
