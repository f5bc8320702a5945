use std::ptr::NonNull;

use zerocopy::FromZeros as _;

use super::super::tiles::tile_count;
use super::super::{Split, Units};
use super::*;

const SIZE: Geometry = Geometry { width: 640, height: 160 };
const TILES: usize = 100;

const HEAD: &str = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 20\nhither 0\nresolution 640 160\n\
                    b 0 0 1\nf 1 0.5 0.25 1 0 0 0 1\n";
/// Small spheres at the left, in the middle and at the right. The first and the last determine the
/// range of the depth shading.
const SPHERES: &str = "s -2 -5 0 0.1\ns 0 0 0 0.1\ns 5 5 0 0.1\n";

fn scene(text: &str) -> Scene {
    let scene = scenes::parse(text.as_bytes(), "test", &scenes::Limits::default()).unwrap();
    Scene::from_nff(&scene).unwrap()
}

/// Memory that is not written to, because only its address matters here.
struct Screen {
    pages: [u128; 2],
    known: Pages,
}

impl Screen {
    fn new() -> Self {
        Self { pages: [0; 2], known: Pages::default() }
    }

    fn target(&mut self, page: usize) -> Target {
        Target {
            base: NonNull::from(&mut self.pages[page]).cast(),
            bytes: 640 * 160 * 4,
            stride: 640 * 4,
            geometry: SIZE,
            format: PixelFormat::ARGB,
        }
    }

    /// The tiles to trace of a frame that is not finished.
    fn open(&mut self, page: usize, scene: &Scene) -> Vec<u32> {
        let target = self.target(page);
        self.open_target(&target, scene)
    }

    fn open_target(&mut self, target: &Target, scene: &Scene) -> Vec<u32> {
        let camera = scene.camera(SIZE.width, SIZE.height).unwrap();
        let projection = Projection::new(&camera, SIZE);
        let mut changes = Changes::default();
        self.known.open(target, scene, &camera, &projection, &mut changes);
        changes.tiles.numbers().to_vec()
    }

    fn show(&mut self, page: usize, scene: &Scene) -> Vec<u32> {
        let tiles = self.open(page, scene);
        self.known.close(&[], &[], &mut TileSet::default());
        tiles
    }
}

#[test]
fn unchanged_page_is_not_traced_again() {
    assert_eq!(tile_count(SIZE) as usize, TILES);
    let scene = scene(&format!("{HEAD}{SPHERES}"));
    let mut screen = Screen::new();
    for page in [0, 1] {
        assert_eq!(screen.show(page, &scene).len(), TILES, "page {page} is new");
    }
    for page in [0, 1, 1, 0] {
        assert!(screen.show(page, &scene).is_empty());
    }
}

#[test]
fn moved_sphere_is_traced_at_its_old_and_new_place() {
    let before = scene(&format!("{HEAD}{SPHERES}"));
    // The middle sphere moves to the right by three spheres' widths.
    let after = scene(&format!("{HEAD}{}", SPHERES.replace("s 0 0 0", "s 0.6 0 0")));
    let mut screen = Screen::new();
    for page in [0, 1] {
        screen.show(page, &before);
    }
    // 160 rows cover 20 degrees. At a distance of 10, 0.1 is about 4.5 pixels. The sphere was
    // around column 320 and row 80, and is 27 columns further now.
    let around_both = [44, 45, 54, 55];
    assert_eq!(screen.show(0, &after), around_both);
    assert!(screen.show(0, &after).is_empty());
    assert_eq!(screen.show(1, &after), around_both, "each page has its own past");
    assert_eq!(screen.show(1, &before), around_both);
}

#[test]
fn colour_change_is_traced() {
    let before = scene(&format!("{HEAD}{SPHERES}"));
    let mut screen = Screen::new();
    screen.show(0, &before);
    let red = "f 1 0 0 1 0 0 0 1\n";
    let changed = SPHERES.replace("s 0 0 0", &format!("{red}s 0 0 0"));
    // The last sphere has the new colour too.
    assert_eq!(screen.show(0, &scene(&format!("{HEAD}{changed}"))), [44, 45, 47, 54, 55, 57]);
}

#[test]
fn added_and_removed_spheres_are_changes() {
    let two = scene(&format!("{HEAD}s -2 -5 0 0.1\ns 5 5 0 0.1\n"));
    let three = scene(&format!("{HEAD}s -2 -5 0 0.1\ns 5 5 0 0.1\ns 0 0 0 0.1\n"));
    let mut screen = Screen::new();
    screen.show(0, &two);
    assert_eq!(screen.show(0, &three), [44, 45, 54, 55]);
    assert_eq!(screen.show(0, &two), [44, 45, 54, 55]);
    let unseen = scene(&format!("{HEAD}s -2 -5 0 0.1\ns 5 5 0 0.1\ns 0 -16 0 0.1\n"));
    assert!(screen.show(0, &unseen).is_empty());
}

#[test]
fn view_background_or_depth_change_traces_all() {
    let first = format!("{HEAD}{SPHERES}");
    let mut screen = Screen::new();
    for other in [
        first.replace("from 0 -10 0", "from 0 -10 0.001"),
        first.replace("b 0 0 1", "b 0 0 0.9"),
        first.replace("s 5 5 0", "s 5 6 0"),
        first.clone(),
    ] {
        screen.show(0, &scene(&first));
        let expected = if other == first { 0 } else { TILES };
        assert_eq!(screen.show(0, &scene(&other)).len(), expected, "{other}");
    }
}

#[test]
fn unfinished_frame_is_traced_again() {
    let scene = scene(&format!("{HEAD}{SPHERES}"));
    let mut screen = Screen::new();
    screen.show(0, &scene);
    assert!(screen.open(0, &scene).is_empty());
    assert_eq!(screen.open(0, &scene).len(), TILES);
    screen.known.close(&[], &[], &mut TileSet::default());
    screen.known.forget();
    assert_eq!(screen.open(0, &scene).len(), TILES);
}

#[test]
fn same_address_with_other_format_is_another_page() {
    let scene = scene(&format!("{HEAD}{SPHERES}"));
    let mut screen = Screen::new();
    screen.show(0, &scene);
    let mut target = screen.target(0);
    target.format.red_shift = 24;
    assert_eq!(screen.open_target(&target, &scene).len(), TILES);
    let mut target = screen.target(0);
    target.stride += 16;
    assert_eq!(screen.open_target(&target, &scene).len(), TILES);
}

#[test]
fn tiles_are_blank_while_the_background_stays() {
    let mut screen = Screen::new();
    let before = scene(&format!("{HEAD}{SPHERES}"));
    screen.open(0, &before);
    let mut units = Units::default();
    units.split(&[3, 5], 1, Split::Units, None);
    let mut costs = vec![UnitCost::new_zeroed(); units.lines().len()];
    for (unit, cost) in units.lines().iter().zip(&mut costs) {
        cost.count = unit.count;
        for (tile, ticks) in unit.tiles.iter().zip(&mut cost.ticks) {
            *ticks = (7 | if tile.get() == 5 { TILE_BLANK } else { 0 }).into();
        }
    }
    screen.known.close(units.lines(), &costs, &mut TileSet::default());
    let blank = |screen: &Screen| {
        let blank = screen.known.blank().unwrap();
        (0..TILES as u32).filter(|&tile| blank.contains(tile)).collect::<Vec<_>>()
    };
    assert_eq!(blank(&screen), [5]);
    screen.open(1, &before);
    assert_eq!(blank(&screen), [0; 0], "another page");
    screen.open(0, &before);
    assert_eq!(blank(&screen), [5]);
    let other = scene(&format!("{}{SPHERES}", HEAD.replace("b 0 0 1", "b 0 1 0")));
    screen.known.close(&[], &[], &mut TileSet::default());
    screen.open(0, &other);
    assert_eq!(blank(&screen), [0; 0], "another background");
}
