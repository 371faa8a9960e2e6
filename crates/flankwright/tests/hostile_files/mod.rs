//! Every reader of files against what may stand under a name: nothing, no regular file, too much, another encoding, half a file, lines in
//! another order, numbers that are none. The answer is content or an error in full, within a moment. What random bytes do is asked by
//! the targets of `fuzz/`.

mod names;
mod numbers;
mod readers;
mod sizes;
mod texts;
