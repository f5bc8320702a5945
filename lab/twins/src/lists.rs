//! Twins of `list_places_p64`, `list_pairs_p64` and `mask_pairs_p64` in `spu/isect/`: lists
//! of those packets that masks name, and the masks that name those of a list.

/// The bit of a mask that names the group's first packet; those of the next ones are lower.
const FIRST: u32 = 0x8000;

/// The words of a place: packet, pixels, x, y.
pub type Place = [u32; 4];

/// The places that masks name, in each the highest of 16 bits the first, with `origin` added.
#[must_use]
pub fn list_places(masks: [u32; 4], places: &[Place; 64], origin: Place) -> Vec<Place> {
    let add = |place: &Place| std::array::from_fn(|word| place[word].wrapping_add(origin[word]));
    named(masks, places).map(add).collect()
}

/// The pairs of an object with the packets that masks name: addresses of the object's record and
/// of the packet.
#[must_use]
pub fn list_pairs(masks: [u32; 4], places: &[Place; 64], object: u32) -> Vec<[u32; 2]> {
    named(masks, places).map(|&[packet, ..]| [object, packet]).collect()
}

/// The masks that name packets of a tile, given by their numbers: one for each sixteen.
#[must_use]
pub fn mask_pairs(packets: &[usize]) -> [u32; 4] {
    let mut masks = [0; 4];
    for packet in packets {
        masks[packet / 16] |= FIRST >> (packet % 16);
    }
    masks
}

fn named(masks: [u32; 4], places: &[Place; 64]) -> impl Iterator<Item = &Place> {
    let is_named = move |number: usize| masks[number / 16] & FIRST >> (number % 16) != 0;
    places.iter().enumerate().filter_map(move |(number, place)| is_named(number).then_some(place))
}
