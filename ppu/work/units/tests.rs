use rand::seq::SliceRandom as _;
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use super::*;

fn tiles(unit: &WorkUnit) -> Vec<u32> {
    unit.tiles[..unit.count.get() as usize].iter().map(|tile| tile.get()).collect()
}

/// Checks that the units have every wanted tile once, and no more tiles than a line holds.
fn check(units: &Units, wanted: &[u32]) {
    for unit in units.lines() {
        assert!((1..=UNIT_TILES).contains(&unit.count.get()));
        assert!(unit.tiles[unit.count.get() as usize..].iter().all(|tile| tile.get() == 0));
    }
    let mut found: Vec<u32> = units.lines().iter().flat_map(tiles).collect();
    found.sort_unstable();
    assert_eq!(found, wanted);
}

#[test]
fn every_tile_is_in_one_unit() {
    let mut random = ChaCha8Rng::seed_from_u64(21);
    let mut units = Units::default();
    for count in [0, 1, 5, 24, 25, 144, 145, 900, 5000, 65536] {
        let mut wanted: Vec<u32> = (0..65536).collect();
        wanted.shuffle(&mut random);
        wanted.truncate(count);
        wanted.sort_unstable();
        let even = vec![7; 65536];
        let costs: Vec<u32> =
            (0..65536).map(|_| libm::exp2(random.random_range(0.0..32.0f64)) as u32).collect();
        for spus in [1, 2, 6, 16] {
            for split in [Split::Units, Split::Slices] {
                for costs in [None, Some(even.as_slice()), Some(costs.as_slice())] {
                    units.split(&wanted, spus, split, costs);
                    check(&units, &wanted);
                    assert!(units.lines().len() <= count.max(1));
                }
            }
        }
    }
}

#[test]
fn units_without_costs_shrink_towards_end() {
    let wanted: Vec<u32> = (0..900).collect();
    let mut units = Units::default();
    for (spus, first, count) in [(6, 4, 40..50), (16, 2, 28..36), (1, 19, 50..65)] {
        units.split(&wanted, spus, Split::Units, None);
        let order: Vec<u32> = units.lines().iter().flat_map(tiles).collect();
        assert_eq!(order, wanted);
        let sizes: Vec<u32> = units.lines().iter().map(|unit| unit.count.get()).collect();
        assert_eq!(sizes[0], first);
        assert!(sizes.is_sorted_by(|before, after| before >= after), "{sizes:?}");
        assert!(sizes[sizes.len() - 3..] == [1, 1, 1], "{sizes:?}");
        let an_spu = units.lines().len() as u32 / spus;
        assert!(count.contains(&an_spu), "{an_spu} on {spus} SPUs");
        let end = units.lines().len() as u32;
        assert!(units.slices().iter().all(|first| first.get() == end));
    }
}

#[test]
fn units_with_costs_start_expensive_and_end_small() {
    let mut random = ChaCha8Rng::seed_from_u64(22);
    let wanted: Vec<u32> = (0..900).collect();
    let costs: Vec<u32> = wanted.iter().map(|_| random.random_range(100..3000)).collect();
    let cost = |tile: &u32| u64::from(costs[*tile as usize]);
    let mut units = Units::default();
    units.split(&wanted, 6, Split::Units, Some(&costs));
    let order: Vec<u32> = units.lines().iter().flat_map(tiles).collect();
    let sum: u64 = wanted.iter().map(cost).sum();
    let (dear, cheap): (Vec<u32>, Vec<u32>) =
        order.iter().partition(|tile| 2 * cost(tile) * 900 >= sum);
    assert!(dear.is_sorted_by_key(|tile| Reverse(cost(tile))));
    assert!(cheap.is_sorted_by_key(|tile| Reverse(cost(tile))));
    let early = |tile: &&u32| order[..450].contains(tile);
    let share = cheap.iter().filter(early).count() as f64 / cheap.len() as f64;
    assert!((0.2..0.5).contains(&share), "{share} of the cheap tiles in the first half");
    assert!(order[900 - 6 * CHEAP_AT_THE_END..].iter().all(|tile| cheap.contains(tile)));
    let sums: Vec<u64> =
        units.lines().iter().map(|unit| tiles(unit).iter().map(cost).sum()).collect();
    let all: u64 = sums.iter().sum();
    let mut left = all;
    for (unit, sum) in units.lines().iter().zip(&sums) {
        let share = (left / (6 * PARTS_OF_A_SHARE)).max(all / (6 * PARTS_OF_THE_WHOLE));
        assert!(*sum <= share || unit.count.get() == 1, "{sum} of {left}");
        left -= sum;
    }
    assert!(sums[0] > all / 30, "the first unit is large: {} of {all}", sums[0]);
    assert!(
        sums[sums.len() - 6..].iter().all(|&sum| sum <= all / (6 * PARTS_OF_THE_WHOLE)),
        "{sums:?}"
    );
}

/// Simulates SPUs that each take the next unit. Returns the time of the last SPU, relative to the
/// time of a perfect split.
fn imbalance(units: &Units, spus: usize, costs: &[u32]) -> f64 {
    let mut ends = vec![0u64; spus];
    for unit in units.lines() {
        let next = ends.iter_mut().min().unwrap();
        *next += tiles(unit).iter().map(|&tile| u64::from(costs[tile as usize])).sum::<u64>();
    }
    let all: u64 = ends.iter().sum();
    *ends.iter().max().unwrap() as f64 * spus as f64 / all as f64
}

#[test]
fn known_costs_balance_an_uneven_picture() {
    // One corner of the picture costs fifty times as much as the rest.
    let wanted: Vec<u32> = (0..900).collect();
    let dear = |tile: u32| tile % 20 >= 10 && tile / 20 >= 25;
    let costs: Vec<u32> = wanted.iter().map(|&tile| if dear(tile) { 5000 } else { 100 }).collect();
    let mut units = Units::default();
    units.split(&wanted, 6, Split::Units, Some(&costs));
    let known = imbalance(&units, 6, &costs);
    assert!(known < 1.02, "{known}");
    // Two tiles an SPU cost as much as all others.
    let dear = |tile: u32| tile.is_multiple_of(75);
    let few: Vec<u32> =
        wanted.iter().map(|&tile| if dear(tile) { 7500 + tile } else { 100 }).collect();
    units.split(&wanted, 6, Split::Units, Some(&few));
    let known = imbalance(&units, 6, &few);
    assert!(known < 1.02, "{known}");
    units.split(&wanted, 6, Split::Units, None);
    let unknown = imbalance(&units, 6, &costs);
    assert!(known < unknown, "{known} {unknown}");
}

#[test]
fn slices_are_consecutive_and_equal_in_tiles() {
    let mut units = Units::default();
    for count in [0u32, 1, 5, 6, 7, 900, 65536] {
        let wanted: Vec<u32> = (0..count).map(|tile| tile * 3).collect();
        for spus in 1..=MAX_SPUS {
            units.split(&wanted, spus, Split::Slices, None);
            check(&units, &wanted);
            let order: Vec<u32> = units.lines().iter().flat_map(tiles).collect();
            assert_eq!(order, wanted);
            let slices = units.slices().map(U32::get);
            assert_eq!(slices[0], 0);
            for number in 0..spus as usize {
                let slice = &units.lines()[slices[number] as usize..slices[number + 1] as usize];
                let tiles: u32 = slice.iter().map(|unit| unit.count.get()).sum();
                assert!(tiles.abs_diff(count / spus) <= 1, "{count} tiles, {spus} SPUs");
            }
            let end = units.lines().len() as u32;
            assert!(slices[spus as usize..].iter().all(|&first| first == end));
        }
    }
}

#[test]
fn costs_come_from_last_frame() {
    let geometry = Geometry { width: 256, height: 32 };
    let mut costs = TileCosts::default();
    let mut in_part = TileSet::default();
    assert_eq!(costs.of(geometry, &in_part), None);
    let mut units = Units::default();
    let cost =
        |unit: &WorkUnit, ticks: u32| UnitCost { count: unit.count, ticks: [ticks.into(); 31] };
    units.split(&[0, 1, 2, 3, 4, 5, 6, 7], 1, Split::Units, None);
    let costs_of_units: Vec<UnitCost> =
        (10..).zip(units.lines()).map(|(ticks, unit)| cost(unit, ticks)).collect();
    costs.learn(geometry, units.lines(), &costs_of_units);
    assert_eq!(costs.of(geometry, &in_part), Some(&[10, 11, 12, 13, 14, 15, 16, 17][..]));
    units.split(&[2, 6], 1, Split::Units, costs.of(geometry, &in_part));
    assert_eq!(units.lines().iter().flat_map(tiles).collect::<Vec<_>>(), [6, 2]);
    let costs_of_units = [cost(&units.lines()[0], 50), UnitCost::new_zeroed()];
    costs.learn(geometry, units.lines(), &costs_of_units);
    assert_eq!(costs.of(geometry, &in_part), Some(&[10, 11, 12, 13, 14, 15, 50, 17][..]));
    // Tiles that were kept keep their costs, unless they may be kept again.
    units.split(&[3, 4], 1, Split::Units, None);
    let costs_of_units: Vec<UnitCost> =
        units.lines().iter().map(|unit| cost(unit, TILE_KEPT | 2)).collect();
    costs.learn(geometry, units.lines(), &costs_of_units);
    in_part.clear(geometry);
    for tile in [4, 7] {
        in_part.set(tile, true);
    }
    assert_eq!(costs.of(geometry, &in_part), Some(&[10, 11, 12, 13, 2, 15, 50, 17][..]));
    let other = Geometry { width: 32, height: 256 };
    assert_eq!(costs.of(other, &in_part), None);
}

/// In units that go upwards each tile is above the one before, and costly units are first.
#[test]
fn strips_go_upwards() {
    let mut units = Units::default();
    let all: Vec<u32> = (0..900).collect();
    let costs: Vec<u32> = (0..900).map(|tile| tile * 977 % 5000).collect();
    for (wanted, spus) in [(&all[..], 6), (&all[37..611], 16), (&all[..3], 1), (&[], 6)] {
        for costs in [None, Some(&costs[..])] {
            units.split_upwards(wanted, 20, spus, costs);
            check(&units, wanted);
            let mut before = u64::MAX;
            for unit in units.lines() {
                let tiles = tiles(unit);
                assert!(tiles.windows(2).all(|pair| pair[0] == pair[1] + 20), "{tiles:?}");
                let cost: u64 = costs
                    .map_or(0, |costs| tiles.iter().map(|&it| u64::from(costs[it as usize])).sum());
                assert!(cost <= before, "{tiles:?}");
                before = cost;
            }
        }
    }
}
