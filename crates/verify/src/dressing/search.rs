//! Block `search`: all pairs of a few worms and dressers for one profile crowning, ranked.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::{Bodies, OtherWorm};
use super::{UM, corrections};
use dressing::catalogue::{
    CatalogueDresser, CatalogueSearch, CatalogueWorm, DresserSize, PairLimits, RankedPair, Wanted, Workshop,
};
use dressing::{DressingError, WormSeat};
use foundation::geometry::{Flank, Sides, WormChoice};
use foundation::numerics::Silent;
use serde_json::Value;

/// The files look at each worm in its own width only; no width enters without undermining.
const NO_WIDTH: f64 = 0.0;

/// The lands of the files come from circles in steps, between which a dresser may touch: they are too wide by up to this, mm
/// (`docs/mathematics/dressing.md#limits-of-a-correction`), never too narrow.
const SAMPLED: f64 = 0.002;

/// Worms by the rule of the files.
struct FileWorms<'a>(&'a Bodies);

impl Workshop for FileWorms<'_> {
    fn seat(&self, worm: &WormChoice, dresser: DresserSize) -> Result<WormSeat, DressingError> {
        let own = self.0.own_worm();
        let other = OtherWorm {
            threads: worm.threads,
            diameter: worm.pitch_diameter.unwrap_or(own.diameter),
            angle: worm.pressure_angle.unwrap_or(own.angle),
        };
        self.0.seat(other, 2.0 * dresser.tip_radius)
    }
}

/// A worm { z_S, d_S_mm, alpha_nS_deg }.
fn choice(bodies: &Bodies, mut table: Expected<'_>, ledger: &mut Ledger) -> Option<WormChoice> {
    let numbers = ["z_S", "d_S_mm", "alpha_nS_deg"].map(|key| table.given(key, ledger));
    let [Some(threads), Some(diameter), Some(angle)] = numbers else { return None };
    if threads.fract() != 0.0 {
        table.refused(&"threads are counted in whole numbers", ledger);
    }
    table.finish(ledger);
    Some(WormChoice {
        threads: threads as i32,
        hand: bodies.worm.data().helix_angle.signum(),
        pitch_diameter: Some(diameter),
        tip_diameter: None,
        pressure_angle: Some(angle.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
}

fn dresser(bodies: &Bodies, mut table: Expected<'_>, ledger: &mut Ledger) -> Option<CatalogueDresser> {
    let (diameter, crowning) =
        (table.given("d_aA_mm", ledger), table.given("crowning_in_dresser_um", ledger));
    let designed = table.object("designed_for", ledger).and_then(|worm| choice(bodies, worm, ledger));
    table.finish(ledger);
    let (Some(diameter), Some(crowning), Some(designed_for)) = (diameter, crowning, designed) else {
        return None;
    };
    Some(CatalogueDresser {
        name: String::new(),
        size: DresserSize { tip_radius: diameter / 2.0, pitch_radius: None },
        designed_for,
        designed_right_angle: None,
        designed_module: None,
        crowning: Sides::both(crowning * UM),
        tip_land: None,
        flank: None,
    })
}

/// Block `search`, left flank, without undermining and without a limit of the stretch.
pub(super) fn search(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let crowning = item.given("c_alpha_V_um", ledger);
    let worms: Vec<Option<WormChoice>> =
        item.objects("worms", ledger).into_iter().map(|w| choice(bodies, w, ledger)).collect();
    let dressers: Vec<Option<CatalogueDresser>> =
        item.objects("dressers", ledger).into_iter().map(|d| dresser(bodies, d, ledger)).collect();
    let Some(mut table) = item.object("limits", ledger) else { return Ok(()) };
    let axes = ["d_phi_S_deg", "d_gamma_deg", "d_d_mm", "d_v_yA_mm"].map(|key| table.given(key, ledger));
    let land = table.given("tip_land_min_mm", ledger);
    table.finish(ledger);
    let (Some(crowning), Some(tip_land), [Some(phi), Some(gamma), Some(d), Some(v_y)]) =
        (crowning, land, axes)
    else {
        return Ok(());
    };
    let (Some(worms), Some(dressers)) =
        (worms.into_iter().collect::<Option<Vec<_>>>(), dressers.into_iter().collect::<Option<Vec<_>>>())
    else {
        return Ok(());
    };
    let worms: Vec<CatalogueWorm> = worms
        .into_iter()
        .map(|choice| CatalogueWorm {
            name: String::new(),
            choice,
            right_angle: None,
            normal_module: None,
            smallest: None,
            width: NO_WIDTH,
        })
        .collect();
    let workshop = FileWorms(bodies);
    let search = CatalogueSearch {
        workshop: &workshop,
        worms: &worms,
        dressers: &dressers,
        wanted: Wanted {
            crowning: Sides { left: Some(crowning * UM), right: None },
            cos_base_helix: bodies.gear.flanks().map(|_, f| f.base_helix_angle.cos()),
            tolerance: None,
        },
        limits: PairLimits {
            correction: [phi.to_radians(), gamma.to_radians(), d, v_y],
            stretch: None,
            tip_land,
            clearance: 0.0,
        },
        collisions: true,
        life: false,
    };
    let found = search.run(&Silent);
    let rows = item.objects("ranking", ledger);
    if rows.len() != found.len() {
        ledger.fail(item.case(), "search.ranking", rows.len().into(), found.len().into());
    }
    for (mut row, pair) in rows.into_iter().zip(&found) {
        ranked(pair, tolerances, &mut row, ledger);
        row.finish(ledger);
    }
    Ok(())
}

/// One row of the ranking: place, figures, verdict.
fn ranked(pair: &RankedPair, tolerances: Tolerances<'_>, row: &mut Expected<'_>, ledger: &mut Ledger) {
    let case = row.case().to_owned();
    let verdict: [(&str, Value); 3] =
        [("worm", pair.worm.into()), ("dresser", pair.dresser.into()), ("ok", pair.is_ok().into())];
    for (key, actual) in verdict {
        if let Some(expected) = row.take(key) {
            ledger.equal(&case, &format!("search.ranking.{key}"), expected.clone(), actual);
        }
    }
    let Some((figures, flank)) = pair.figures.as_ref().and_then(|f| Some((f, f.flanks[Flank::Left]?))) else {
        let refusal = pair.refusal.as_ref().map_or_else(String::new, ToString::to_string);
        row.refused(&refusal, ledger);
        return;
    };
    let relative = tolerances.get("DK_rel");
    corrections::compare(row, &flank.fit.dk, |_, x| relative * x.abs(), ledger);
    row.number("P", flank.fit.stretch, tolerances.get("P"), ledger);
    row.number("cost", figures.cost, relative * figures.cost, ledger);
    let (land, allowed) = (flank.tip_land.flatten(), tolerances.get("tip_width_mm"));
    let listed = row.peek("tip_width").and_then(Value::as_f64);
    let below = land.zip(listed).is_some_and(|(land, listed)| land < listed);
    row.optional("tip_width", land, if below { allowed + SAMPLED } else { allowed }, ledger);
}
