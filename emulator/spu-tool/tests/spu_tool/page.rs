//! The page of `spu time --html`: what it shows, and that it needs nothing else.
//!
//! How it looks in a browser is for `ci/browser`.

use std::collections::HashSet;

use spu_isa::timing::Rules;
use spu_tool::report::Report;

fn page(program: &str) -> String {
    titled(program, program)
}

fn titled(program: &str, title: &str) -> String {
    let code = crate::report::program(program);
    Report::new(&code, None, Rules::default()).unwrap().html(title)
}

/// What stands between each `before` and the next `after`.
fn all<'t>(text: &'t str, before: &str, after: &str) -> Vec<&'t str> {
    let parts = text.split(before).skip(1);
    parts.filter_map(|part| Some(part.split_once(after)?.0)).collect()
}

/// The number of rectangles in the paths of a class, over the whole page.
fn rectangles(page: &str, class: &str) -> usize {
    let paths = all(page, &format!("<path class=\"{class}\" d=\""), "\"");
    paths.iter().map(|path| path.matches('M').count()).sum()
}

#[test]
fn every_instruction_has_a_row_and_a_cell_in_its_pipe() {
    let page = page("saxpy");
    // 25 words straight on; 16 in the loop's steady state.
    let rows = all(&page, "<tr id=\"", "\"");
    assert_eq!(rows.len(), 25 + 16);
    // Each is in the picture and in the strip above it.
    assert_eq!(rectangles(&page, "e") + rectangles(&page, "o"), 2 * (25 + 16));
    assert_eq!(page.matches("<td class=\"even\">even</td>").count(), 10 + 8);
    assert!(page.contains("lqd $10,0($4)"));
    // 9 pairs straight on and 7 in the loop have a mark each.
    let pairs = all(&page, "<path class=\"pair\" d=\"", "\"");
    assert_eq!(pairs.iter().map(|path| path.matches('M').count()).sum::<usize>(), 9 + 7);
}

#[test]
fn waits_lead_to_the_instruction_that_is_waited_for() {
    let page = page("saxpy");
    assert!(page.contains("3 for $12 from <a href=\"#f0-0000c\">0000c</a>"), "{page}");
    // One wait of 3 cycles straight on.
    let waits = all(&page, "<path class=\"wait\" d=\"", "\"");
    assert_eq!(waits.len(), 1);
    assert!(waits[0].contains("h33v"), "{}", waits[0]);
    for program in ["saxpy", "straight", "hints"] {
        let page = self::page(program);
        let ids: HashSet<_> = all(&page, " id=\"", "\"").into_iter().collect();
        for link in all(&page, "href=\"", "\"") {
            let name = link.strip_prefix('#');
            assert!(name.is_some_and(|name| ids.contains(name)), "{program}: {link}");
        }
    }
}

#[test]
fn loops_are_shown_in_their_steady_state_with_the_bound_marked() {
    let page = page("saxpy");
    assert!(page.contains(
        "<strong>9 cycles a pass, bound 8</strong>. The bound is the even pipe and the odd pipe."
    ));
    // The mark stands 8 cycles of 11 pixels from the left.
    assert!(page.contains("<path class=\"bound\" d=\"M88 0V"), "{page}");
    assert!(page.contains(">bound 8</text>"));
}

#[test]
fn a_page_needs_neither_scripts_nor_a_network() {
    let page = page("hints");
    for foreign in ["<script", "http", "src=", "@import", "url("] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert!(page.contains("too near to be seen"));
}

#[test]
fn names_are_escaped() {
    let page = titled("saxpy", "<b>a&b</b>");
    assert!(page.contains("&lt;b&gt;a&amp;b&lt;/b&gt;"));
    assert!(!page.contains("<b>a"));
}
