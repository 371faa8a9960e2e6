//! Large files, made to take time or memory: an answer soon.

use std::time::{Duration, Instant};

use super::readers::all;

/// Bytes of a file: a way that grows with the square of their number takes minutes.
const BYTES: usize = 1 << 20;

/// Longest time of one file on a busy machine.
const SOON: Duration = Duration::from_secs(30);

fn filled(head: &str, piece: impl Fn(usize) -> String) -> Vec<u8> {
    let mut text = head.to_owned();
    for k in 0.. {
        let piece = piece(k);
        if text.len() + piece.len() > BYTES {
            break;
        }
        text += &piece;
    }
    text.into_bytes()
}

#[test]
fn no_way_through_a_file_grows_with_the_square_of_its_size() {
    let same = |piece: &'static str| move |_| piece.to_owned();
    let files = [
        ("opened lists", filled("x = ", same("["))),
        ("opened objects", filled("", same("{\"a\":"))),
        ("opened elements", filled("<model>", same("<a>"))),
        ("dotted keys", filled("a", same(".a"))),
        ("tables of a list", filled("", same("[[worm]]\n"))),
        ("keys", filled("", |k| format!("k{k} = {k}\n"))),
        ("tables", filled("", |k| format!("[t{k}]\n"))),
        ("quotation marks", filled("", same("\""))),
        ("commas", filled("", same(","))),
        ("empty lines", filled("", same("\n"))),
        ("one line", filled("", same("a"))),
        ("places of a grid", filled("w_mm,z_mm,f_um\n", |k| format!("{k},{k},1\n"))),
        (
            "traces of one sample",
            filled("kind,tooth,flank,position,abscissa,f_um\n", |k| format!("helix,1,left,{k},0,1\n")),
        ),
        (
            "one trace",
            filled("kind,tooth,flank,position,abscissa,f_um\n", |k| format!("helix,1,left,0,{k},1\n")),
        ),
        ("fields", filled("tooth,flank,w_mm,z_mm,f_um\n", |k| format!("{},left,0,{k},1\n", k % 65_536))),
        ("pulses", filled("tick,sign\n", |k| format!("{},1\n", k + 1))),
        ("values", filled("HEADER KS.MW.FILE\n", |k| format!("{} : a : 1\n", 10_000 + k % 90_000))),
        (
            "traces cut short",
            filled("HEADER KS.MK.FILE\n", same("Zahn-Nr.: 1 links / 20000 Werte z= 3\n1\n")),
        ),
    ];
    for reader in all() {
        for (what, bytes) in &files {
            let start = Instant::now();
            let _ = reader.take(bytes);
            let taken = start.elapsed();
            assert!(taken < SOON, "{}: {what}: {taken:?}", reader.name);
        }
    }
}
