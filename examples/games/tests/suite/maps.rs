//! Traces a picture of maps of Freedoom: a tenth of them, or all with `CELLRAY_TEST_ROUNDS=10`.

use std::collections::HashSet;
use std::time::Duration;

use cellray::Settings;
use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, NoInput, Session};
use games::station::Station;
use levels::Wad;
use randomness::rounds;

use crate::station::freedoom;

/// The maps of both files, and a number without a divisor in common: so the first maps that are
/// taken are of all episodes.
const MAPS: usize = 68;
const STRIDE: usize = 29;

#[test]
fn maps_of_freedoom_are_traced() {
    let files = ["freedoom1.wad", "freedoom2.wad"].map(freedoom);
    let maps = files.iter().flat_map(|file| {
        Wad::open(file).unwrap().maps().into_iter().map(move |name| (file, name.to_string()))
    });
    let maps: Vec<_> = maps.collect();
    assert_eq!(maps.len(), MAPS);
    for number in (0..rounds(7) as usize).take(MAPS) {
        let (file, name) = &maps[number * STRIDE % MAPS];
        let game = Station::open(file, Some(name)).unwrap();
        let picture = Memory::new(Geometry::new(64, 36).unwrap()).unwrap();
        let session = Session::start(game, Settings::default(), Box::new(picture));
        let mut session = session.unwrap_or_else(|error| panic!("{name}: {error}"));
        let outcome = session.frame(&mut FixedSteps(Duration::ZERO), &mut NoInput);
        assert!(outcome.unwrap_or_else(|error| panic!("{name}: {error}")).is_continue(), "{name}");
        let picture = session.engine().picture().unwrap();
        let colours: HashSet<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
        println!("{name}: {} colours", colours.len());
        assert!(colours.len() > 50, "{name}: {} colours", colours.len());
    }
}
