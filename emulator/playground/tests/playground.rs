//! Tests what the page asks for, without a browser.

use serde_json::{Value, json};
use spu_exchange::Program as _;
use spu_playground::Playground;

const LOOP: &str = "\
        ila     $3,numbers
        il      $4,3
again:  lqd     $5,0($3)
        ai      $5,$5,1
        stqd    $5,0($3)
        ai      $4,$4,-1
        brnz    $4,again
        stop    0x2000
        .data
        .align  4
numbers: .long  1,2,3,4
";

/// The reply to a request.
fn ask(playground: &mut Playground, request: Value) -> Value {
    let reply = playground.reply(request.to_string().as_bytes());
    serde_json::from_str(&reply).expect("an reply is JSON")
}

fn loaded(source: &str) -> Playground {
    let mut playground = Playground::default();
    let reply = ask(&mut playground, json!({ "load": { "source": source } }));
    assert!(reply["lines"].is_array(), "{reply}");
    playground
}

/// The state after this many instructions, with the first 16 quadwords of local store.
fn go(playground: &mut Playground, step: u64) -> Value {
    ask(playground, json!({ "go": { "step": step }, "quadwords": [0, 16] }))
}

#[test]
fn a_step_back_gives_the_state_of_before() {
    let mut playground = loaded(LOOP);
    let forwards: Vec<Value> = (0..=18).map(|step| go(&mut playground, step)).collect();
    assert_eq!(forwards[18]["stopped"], "stop 0x2000 at 0x0001c");
    assert_eq!(forwards[18]["step"], 18);
    for (step, then) in forwards.iter().enumerate().rev() {
        assert_eq!(go(&mut playground, step as u64), *then, "step {step}");
    }
    // Steps also agree with leaps.
    assert_eq!(go(&mut loaded(LOOP), 11), forwards[11]);
    assert_eq!(go(&mut playground, 1000)["step"], 18, "there is nothing after the end");
}

#[test]
fn a_state_names_what_the_last_instruction_wrote() {
    let mut playground = loaded(LOOP);
    let store = go(&mut playground, 5);
    assert_eq!(store["written"], json!({ "registers": [], "quadword": 0x80 }));
    assert_eq!(store["store"][8], "00000002 00000003 00000004 00000005");
    let sum = go(&mut playground, 4);
    assert_eq!(sum["written"], json!({ "registers": [5], "quadword": null }));
    assert_eq!(sum["registers"][5], "00000002 00000003 00000004 00000005");
    assert_eq!(sum["store"][8], "00000001 00000002 00000003 00000004");
}

#[test]
fn a_run_ends_at_breakpoints_and_at_its_limit() {
    let mut playground = loaded(LOOP);
    let run = |playground: &mut Playground, at: &[u32]| {
        ask(playground, json!({ "run": { "breakpoints": at } }))
    };
    let steps = [2, 7, 12].map(|_| run(&mut playground, &[8])["step"].clone());
    assert_eq!(steps, [2, 7, 12]);
    assert_eq!(run(&mut playground, &[])["stopped"], "stop 0x2000 at 0x0001c");

    let mut endless = loaded("again:  br again\n");
    for times in 1..=2 {
        let state = run(&mut endless, &[]);
        assert_eq!(state["stopped"], Value::Null);
        assert_eq!(state["step"], times * 5_000_000_u64);
    }
}

#[test]
fn errors_name_their_places() {
    let mut playground = loaded(LOOP);
    let source = "        il      $3,1\n        frob    $3\n        ai      $3,$200,1\n";
    let reply = ask(&mut playground, json!({ "load": { "source": source } }));
    let places: Vec<_> = reply["errors"].as_array().expect("errors").iter().collect();
    assert_eq!(places.len(), 2, "{reply}");
    assert_eq!((&places[0]["line"], &places[0]["column"]), (&json!(2), &json!(9)));
    assert_eq!(places[1]["line"], 3);
    // The program of before is gone.
    assert!(go(&mut playground, 1)["fault"].is_string());

    let unknown = ask(&mut playground, json!({ "frob": {} }));
    assert!(unknown["fault"].as_str().is_some_and(|fault| fault.starts_with("not a request")));
    let none = ask(&mut playground, json!({ "schedule": { "source": LOOP } }));
    assert!(none["error"].as_str().is_some_and(|error| error.contains("no function")), "{none}");
}

#[test]
fn channels_stops_and_invalid_words_stop_the_program() {
    for (source, reason) in [
        (
            "        rdch    $3,$ch24\n",
            "rdch is not possible on channel 24 at 0x00000; the playground has",
        ),
        ("        .long   0x00000001\n", "stop 0x0001 at 0x00000"),
        ("        .long   0x00a00000\n", "invalid instruction 0x00a00000 at 0x00000"),
    ] {
        let stopped = go(&mut loaded(source), 1)["stopped"].clone();
        assert!(stopped.as_str().is_some_and(|stopped| stopped.starts_with(reason)), "{stopped}");
    }
}

#[test]
fn mail_is_read_and_sent_and_the_decrementer_counts() {
    let mut playground = Playground::default();
    let source = include_str!("../page/examples/mail.s");
    ask(&mut playground, json!({ "load": { "source": source, "mail": [100] } }));
    let run = json!({ "run": { "breakpoints": [] } });
    let waits = ask(&mut playground, run.clone());
    let stopped = waits["stopped"].as_str().expect("it waits");
    assert_eq!(stopped, "waits for a channel at 0x00000; the PPE has sent no more words");
    assert_eq!(waits["mail"]["read"], 1);
    let took = waits["mail"]["outbound"][0].as_u64().expect("a word");
    // A pass of the loop takes 20 cycles and more, for want of a hint, and a tick 40.
    assert!((50..60).contains(&took), "{took}");
    assert_eq!(waits["decrementer"].as_u64().map(|now| now <= 0xffff_ffff - took), Some(true));

    // A step back, and forth with more mail.
    let step = waits["step"].as_u64().expect("a number");
    assert_eq!(go(&mut playground, 1)["mail"]["outbound"], json!([]));
    let more = ask(&mut playground, json!({ "send": { "mail": [100, 0] } }));
    assert_eq!((&more["step"], &more["mail"]["read"]), (&json!(1), &json!(1)));
    assert_eq!(go(&mut playground, step)["mail"]["outbound"], json!([took]));
    let end = ask(&mut playground, run);
    assert!(end["stopped"].as_str().is_some_and(|end| end.starts_with("stop 0x2000")), "{end}");
    assert_eq!(end["mail"]["read"], 2);
}

#[test]
fn quadwords_outside_local_store_are_left_out() {
    let mut playground = loaded(LOOP);
    for (asked, shown) in [([0, 64], 64), ([16383, 20000], 1), ([4_000_000_000_u32, 5], 0)] {
        let state = ask(&mut playground, json!({ "go": { "step": 0 }, "quadwords": asked }));
        assert_eq!(state["store"].as_array().map(Vec::len), Some(shown));
    }
}
