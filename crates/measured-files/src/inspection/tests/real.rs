//! Real measurements, where `../shared/measurements` lies beside the repository (MIT licence, TUM FZG; they stay out of it). Skipped
//! where it does not.

use super::super::*;
use foundation::geometry::Flank;
use std::path::{Path, PathBuf};

fn found(name: &str) -> Option<PathBuf> {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path = Some(repository.join("../shared/measurements").join(name)).filter(|path| path.is_file());
    if path.is_none() {
        eprintln!("not run: {name} is not in ../shared/measurements beside the repository");
    }
    path
}

fn part(name: &str) -> Option<[KlingelnbergFile; 2]> {
    let files = [found(&format!("{name}.mka"))?, found(&format!("{name}.mew"))?];
    Some(files.map(|path| read_klingelnberg(&path).unwrap()))
}

#[test]
fn the_steel_pinion() {
    let Some([curves, values]) = part("pinion_95911") else { return };
    for file in [&curves, &values] {
        assert_eq!((file.encoding, file.warnings.len()), (Encoding::Utf8WithMark, 0));
        assert!(file.unknown_lines.is_empty(), "{:?}", file.unknown_lines);
    }
    assert_eq!((curves.kind, values.kind, values.results.len()), (FileKind::Curves, FileKind::Values, 130));
    let whole = inspection_of(&[("mka", &curves), ("mew", &values)]).unwrap();
    assert!(whole.warnings.is_empty(), "{:?}", whole.warnings);
    let [helix, profile] = &whole.traces[..] else { panic!("two traces") };
    assert_eq!(
        (helix.kind, helix.tooth, helix.flank, helix.f_um.len()),
        (TraceKind::Helix, 18, Flank::Left, 480)
    );
    assert_eq!((helix.f_um[1], helix.position_mm), (0.463, 8.953));
    assert_eq!((profile.kind, profile.tooth, profile.f_um[0]), (TraceKind::Profile, 35, -3.278));
    assert_eq!((helix.abscissa_mm[0], helix.abscissa_mm[479]), (-8.5, 8.5));
    assert_eq!(whole.conditions.range(TraceKind::Helix, Flank::Left), Ok([-7.65, 7.649999999999999]));
    let pitch = whole.pitch.as_ref().unwrap();
    assert_eq!(pitch.positions.len(), 102);
    for flank in Flank::BOTH {
        assert_eq!(pitch.flanks[flank].as_ref().unwrap().fp_um.iter().filter(|v| v.is_finite()).count(), 51);
    }
    assert_eq!(whole.circles.root.unwrap().diameters_mm, [48.3802, 48.3887, 48.3701]);
    assert_eq!((whole.gear.teeth, whole.gear.profile_shift), (51, Some(0.203)));
    assert_eq!(whole.thickness.over_balls.unwrap().mean_mm, Some(52.174));
}

#[test]
fn the_plastic_wheel() {
    let Some([curves, values]) = part("wheel_97340") else { return };
    for file in [&curves, &values] {
        assert_eq!((file.encoding, file.warnings.len(), file.unknown_lines.len()), (Encoding::Cp1252, 0, 0));
    }
    assert_eq!(values.results.len(), 164);
    let whole = inspection_of(&[("mka", &curves), ("mew", &values)]).unwrap();
    let helix = &whole.traces[0];
    assert!(helix.f_um[..5].iter().all(|f| f.is_nan()) && helix.f_um[5] == 23.574);
    assert_eq!(whole.run_out.unwrap().fr_um.len(), 52);
    // The limit of the tip relief is absent: the profile ends at code 43.
    assert!(whole.conditions.flanks.left.tip_relief_mm.is_none());
    assert_eq!(whole.gear.profile_shift, Some(0.011));
}
