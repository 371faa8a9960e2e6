//! Contact of the bodies, the exact gap, the stock.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::compare::{Shares, number, numbers, share, table, tables};
use super::input::Input;
use foundation::geometry::Flank;
use grinding_technology::{Cycle, STATIONS, exact_gap};

const UM: f64 = 1e3;
/// Distances ahead of the line at which the exact gap is given, mm.
const AHEAD: [f64; 6] = [-2.0, -1.0, -0.5, 0.5, 1.0, 2.0];
/// Stations of the gap, and of the stock.
const GAP_STATIONS: [usize; 4] = [2, 4, 6, 8];
const STOCK_STATIONS: [usize; 5] = [0, 2, 4, 6, 8];
/// Places of the stock as shares of the face width.
const STOCK_PLACES: [f64; 5] = [-0.5, -0.25, 0.0, 0.25, 0.5];

pub(super) fn check(
    cycle: &Cycle,
    input: &Input,
    expected: &mut Expected<'_>,
    to: &Shares,
    ledger: &mut Ledger,
) {
    let bodies = &cycle.bodies;
    let chain = &bodies.pair.chain;
    number(expected, "crossed_axes_angle_deg", chain.crossed_axes_angle.to_degrees(), to.relative, ledger);
    number(expected, "centre_distance", chain.centre_distance, to.relative, ledger);
    if let Some(mut contact) = expected.object("contact", ledger) {
        for flank in Flank::BOTH {
            let Some(mut item) = contact.object(flank.name(), ledger) else { continue };
            let engagement = &bodies.flanks[flank];
            let [c_c1, c_c2, e] = engagement.raised(0.0);
            numbers(&mut item, &[("E", e), ("C_c1", c_c1), ("C_c2", c_c2)], to.relative, ledger);
            number(&mut item, "flank_area_mm2", engagement.area(), to.relative, ledger);
            let along: [(&str, &dyn Fn(f64) -> f64); 7] = [
                ("w", &|w| w),
                ("w_1", &|w| engagement.worm_roll(w)),
                ("J", &|w| engagement.area_density(w)),
                ("lam", &|w| engagement.profile_width(w)),
                ("H_per_mm", &|w| engagement.gap_curvature(w)),
                ("chi", &|w| engagement.ahead(w)),
                ("wear_factor", &|w| engagement.wear_factor(w)),
            ];
            for (key, figure) in along {
                item.list_to(key, &engagement.stations().map(figure), share(to.relative), ledger);
            }
            item.finish(ledger);
        }
        contact.finish(ledger);
    }
    if let Some(mut gaps) = expected.object("gap_exact_um", ledger) {
        for flank in Flank::BOTH {
            let stations = bodies.flanks[flank].stations();
            let gap = |w: f64, ahead: f64| UM * exact_gap(bodies, flank, w, ahead).unwrap_or(f64::NAN);
            let rows = GAP_STATIONS.map(|i| AHEAD.map(|ahead| gap(stations[i], ahead)).to_vec());
            table(&mut gaps, flank.name(), &rows, (to.gap_um, false), ledger);
        }
        gaps.finish(ledger);
    }
    if let Some(mut stock) = expected.object("stock", ledger) {
        number(&mut stock, "volume_mm3", cycle.stock_volume(), to.volume, ledger);
        for flank in Flank::BOTH {
            let Some(mut item) = stock.object(flank.name(), ledger) else { continue };
            let stations: [f64; STATIONS] = bodies.flanks[flank].stations();
            let of_space = |&space: &usize| -> Vec<Vec<f64>> {
                let at = |i: usize, share: f64| {
                    UM * cycle.stock.at(flank, stations[i], share * bodies.face_width, space)
                };
                STOCK_STATIONS.map(|i| STOCK_PLACES.map(|share| at(i, share)).to_vec()).to_vec()
            };
            let actual: Vec<_> = input.spaces.iter().map(of_space).collect();
            tables(&mut item, "a_um", &actual, (to.a_um, false), ledger);
            let volumes: Vec<f64> =
                input.spaces.iter().map(|&space| cycle.stock_of_space(flank, space)).collect();
            item.list_to("volume_of_space_mm3", &volumes, share(to.volume), ledger);
            item.finish(ledger);
        }
        stock.finish(ledger);
    }
}
