//! Speed of the search in a catalogue: pairs a second at two sizes, with and without tip land and undermining. Equal rates at both
//! sizes show that the time grows with the number of pairs and no faster.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use flankwright::geometry::{Blank, Flank, Gear, GearData, Sides, WormChoice};
use flankwright::numerics::{Silent, equidistant};
use flankwright::process::dressing::catalogue::{
    CatalogueDresser, CatalogueSearch, CatalogueWorm, DresserSize, PairLimits, Wanted, WornDiameter,
};
use flankwright::process::generating::GearWorkshop;
use std::hint::black_box;

fn workshop() -> GearWorkshop {
    let gear = Gear::new(GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: 35f64.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .expect("gear");
    let blank = Blank {
        face_width: 40.0,
        tip_diameter: 88.5315,
        root_diameter: 72.4315,
        tip_form_diameter: 88.5315,
        form_diameter: 76.2065,
        rack_addendum: None,
    };
    GearWorkshop { gear, blank, evaluation: [76.2065, 88.5315, -20.0, 20.0], root_clearance: None }
}

fn choice(threads: i32, pitch_diameter: f64) -> WormChoice {
    WormChoice {
        threads,
        hand: 1.0,
        pitch_diameter: Some(pitch_diameter),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

/// Threads 1 to 5 in turn, diameters from 90 to 280 mm: among the pairs are good ones, refused ones and hopeless ones.
fn bodies(count: usize) -> (Vec<CatalogueWorm>, Vec<CatalogueDresser>) {
    let diameters = equidistant([90.0, 280.0], count);
    let threads = |k: usize| 1 + (k % 5) as i32;
    let worms = diameters.iter().enumerate().map(|(k, &d)| CatalogueWorm {
        name: format!("worm {k}"),
        choice: choice(threads(k), d),
        right_angle: None,
        normal_module: None,
        smallest: Some(WornDiameter::Pitch(0.85 * d)),
        width: 100.0,
    });
    let dressers = diameters.iter().enumerate().map(|(k, &d)| CatalogueDresser {
        name: format!("dresser {k}"),
        size: DresserSize { tip_radius: 50.0 + 2.0 * (k % 8) as f64, pitch_radius: None },
        designed_for: choice(threads(k / 2), d),
        designed_right_angle: None,
        designed_module: None,
        crowning: Sides::both(1e-3 * (k % 4) as f64),
        tip_land: None,
        flank: None,
    });
    (worms.collect(), dressers.collect())
}

fn catalogue(c: &mut Criterion) {
    let workshop = workshop();
    for (name, collisions) in [("figures and life", false), ("with tip land and undermining", true)] {
        let mut group = c.benchmark_group(format!("catalogue, {name}"));
        group.sample_size(10);
        for count in [10, 20] {
            let (worms, dressers) = bodies(count);
            let search = CatalogueSearch {
                workshop: &workshop,
                worms: &worms,
                dressers: &dressers,
                wanted: Wanted {
                    crowning: Sides::both(Some(2e-3)),
                    cos_base_helix: Sides::from_fn(|flank: Flank| {
                        workshop.gear.flank(flank).base_helix_angle.cos()
                    }),
                    tolerance: Some(0.5e-3),
                },
                limits: PairLimits {
                    correction: [10f64.to_radians(), 3f64.to_radians(), 5.0, 10.0],
                    stretch: Some(0.1),
                    tip_land: 0.5,
                    clearance: 0.0,
                },
                collisions,
                life: true,
            };
            group.throughput(Throughput::Elements((count * count) as u64));
            group.bench_function(BenchmarkId::from_parameter(format!("{count} x {count}")), |b| {
                b.iter(|| black_box(search.run(&Silent)));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, catalogue);
criterion_main!(benches);
