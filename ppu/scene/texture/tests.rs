//! Tiles and levels of textures.

use super::*;

/// A texture whose texels are numbers.
fn numbered(width: u32, height: u32, wrap: [Wrap; 2]) -> Arc<Texture> {
    let texels = (0..width * height).map(|number| {
        let [_, red, green, blue] = number.to_be_bytes();
        [red, green, blue]
    });
    Arc::new(Texture::new(width, texels.collect(), wrap).expect("a texture"))
}

fn plain(width: u32, height: u32, texel: impl Fn(u32, u32) -> [u8; 3]) -> Texture {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let texels = places.map(|(x, y)| texel(x, y)).collect();
    Texture::new(width, texels, [Wrap::Repeat; 2]).expect("a texture")
}

/// The texels that a filter takes are those beside each other in the texture, edges included.
#[test]
fn each_tile_has_the_texels_of_its_filters() {
    let beside = |place: i64, count: i64, wrap: Wrap| match wrap {
        Wrap::Repeat => place.rem_euclid(count),
        Wrap::Clamp | Wrap::Mirror => place.clamp(0, count - 1),
    };
    for (width, height) in [(1, 1), (7, 8), (8, 9), (20, 3), (33, 17)] {
        for wrap in
            [[Wrap::Repeat, Wrap::Clamp], [Wrap::Mirror, Wrap::Repeat], [Wrap::Clamp, Wrap::Mirror]]
        {
            let textures = Textures::new(vec![numbered(width, height, wrap)], Colour::Linear);
            let (width, height) = (i64::from(width), i64::from(height));
            let level = &textures.levels[0];
            assert_eq!(i64::from(level.across.get()), width / 8 + 1);
            for (row, column) in (0..=height).flat_map(|y| (0..=width).map(move |x| (y, x))) {
                let tile = row / 8 * i64::from(level.across.get()) + column / 8;
                let tile = &textures.tiles[tile as usize].0;
                for (down, right) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    let place = 9 * (row % 8 + down) + column % 8 + right;
                    let x = beside(column + right - 1, width, wrap[0]);
                    let y = beside(row + down - 1, height, wrap[1]);
                    let found = i64::from(tile[place as usize].get() >> 8);
                    assert_eq!(found, y * width + x, "{width}x{height} {wrap:?}");
                }
            }
        }
    }
}

#[test]
fn levels_halve_until_there_is_one_texel() {
    let textures = Textures::new(vec![numbered(20, 5, [Wrap::Repeat; 2])], Colour::Linear);
    let sizes = textures.levels.iter().map(|level| {
        let (width, height) = (level.width.get(), level.height.get());
        (width as u32, height as u32, level.first.get())
    });
    let sizes: Vec<_> = sizes.collect();
    assert_eq!(sizes, [(20, 5, 0), (10, 2, 3), (5, 1, 5), (2, 1, 6), (1, 1, 7)]);
    assert_eq!(textures.tiles(), 8);
    assert_eq!(textures.bytes().len(), 8 * 384);
    assert!(textures.address().is_multiple_of(128));
}

#[test]
fn levels_average_light_of_texels() {
    let half = |texture: &Texture| Level::new(texture).half().expect("a level");
    let grey = half(&plain(6, 5, |_, _| [90, 7, 200]));
    assert_eq!((grey.width(), grey.height()), (3, 2));
    for (x, y) in [(0, 0), (2, 1)] {
        assert_eq!(grey.texel(x, y), [90, 7, 200]);
    }
    // Half of white's light is 188 on a screen, a third of it 156.
    let stripes = half(&plain(4, 4, |x, _| [255 * (x % 2) as u8; 3]));
    assert_eq!(stripes.texel(1, 1), [188; 3]);
    let of_three = half(&plain(3, 1, |x, _| [if x == 1 { 255 } else { 0 }; 3]));
    assert_eq!((of_three.width(), of_three.texel(0, 0)), (1, [156; 3]));
    // Of five texels, the new ones have two fifths, two fifths and one fifth.
    let of_five = half(&plain(5, 1, |x, _| [if x == 2 { 255 } else { 0 }; 3]));
    assert_eq!((of_five.texel(0, 0), of_five.texel(1, 0)), ([124; 3], [124; 3]));
}

#[test]
fn records_name_each_textures_levels() {
    let sources = [(20, 5), (1, 1), (20, 5)]
        .map(|(width, height)| numbered(width, height, [Wrap::Mirror, Wrap::Clamp]));
    let textures = Textures::new(sources.to_vec(), Colour::Linear);
    let records = textures.records(0x1000);
    // Textures of one size share their levels.
    assert_eq!(records.len(), 16 * (3 + 6));
    let word = |index: usize| u32::from_be_bytes(records[4 * index..][..4].try_into().expect("4"));
    assert_eq!([0, 1, 3].map(word), [0x1030, 4, 12]);
    assert_eq!([4, 5, 7].map(word), [0x1030 + 5 * 16, 0, 12 + 16 * 8]);
    assert_eq!([8, 9, 11].map(word), [0x1030, 4, 12 + 16 * 9]);
    assert_eq!(f32::from_bits(word(2)), 100.0);
    assert_eq!(textures.number_of(&sources[1]), Some(1));
    assert_eq!(textures.number_of(&numbered(1, 1, [Wrap::Clamp; 2])), None);
}

/// In sRGB a tile has square roots of light, whose squares are less than two thirds of a step
/// of the screen away from what they stand for.
#[test]
fn srgb_tiles_store_square_roots_of_light() {
    let texture = plain(256, 1, |x, _| [x as u8, 255, 0]);
    let textures = Textures::new(vec![Arc::new(texture)], Colour::Srgb);
    for (byte, place) in (0..256_usize).map(|byte| (byte, byte + 1)) {
        // The second row of a tile is the texture's only one, after a texel of its edge.
        let tile = place / STEP * TEXTURE_TILE as usize;
        let texel = &textures.bytes()[tile + 4 * (STEP + 1 + place % STEP)..][..4];
        let shown = 255.0 * encode((f64::from(texel[0]) / 255.0).powi(2));
        assert!((shown - byte as f64).abs() < 0.66, "{byte}: {shown}");
        assert_eq!(texel[1..], [255, 0, 0]);
    }
}

fn encode(light: f64) -> f64 {
    match light {
        light if light <= 0.003_130_8 => 12.92 * light,
        light => 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055,
    }
}
