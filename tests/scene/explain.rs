//! The plan of a scene: what is chosen, what is skipped, and that it says so.

use polhode::scene::{self, Costs, Explanation, explain};
use polhode::source::Source;

/// The explanation of a scene of one body.
fn explained(body: &str, run: &str) -> Explanation {
    let text = format!("[[body]]\nname = 'a'\n{body}\n[run]\nduration = 10\n{run}\n");
    let scene = scene::read(&Source::new("scene.toml", text)).expect("a good scene");
    explain(&scene.groups[0], &scene.run).expect("a plan")
}

fn skips(found: &Explanation) -> Vec<&str> {
    found.skipped.iter().map(|skip| skip.what).collect()
}

const UNEQUAL: &str = "inertia = { xx = 2, yy = 3, zz = 4 }\nangular_velocity = [0.1, 3, 0]";

#[test]
fn a_method_is_chosen_by_what_the_motion_is() {
    let ball = "inertia = { xx = 3, yy = 3, zz = 3 }\nangular_velocity = [0.1, 3, 0]";
    let still = "inertia = { xx = 2, yy = 3, zz = 4 }\nangular_velocity = [0, 0, 0]";
    let damping = "\ntorque = { kind = 'damping', coefficient = 0.1 }";
    let gravity = "\ntorque = { kind = 'gravity', weight = 1, arm = [0, 0.1, 1] }";
    let cases = [
        (UNEQUAL.to_owned(), "", "closed form, free body"),
        (ball.to_owned(), "", "closed form, spin about a fixed axis"),
        (still.to_owned(), "", "at rest"),
        (still.to_owned() + damping, "", "at rest"),
        (
            ball.to_owned() + damping,
            "",
            "closed form, spin about a fixed axis",
        ),
        (
            UNEQUAL.to_owned() + damping,
            "",
            "Taylor series, 1e-12 a step",
        ),
        (
            UNEQUAL.to_owned() + gravity,
            "tolerance = 0.05",
            "DOP853, 6e-5 a step",
        ),
        (
            "inertia = { xx = 2, yy = 3, zz = 4 }\nangular_velocity = [1e-40, 3e-40, 0]".to_owned()
                + damping,
            "",
            "DOP853, 2e-11 a step",
        ),
        (
            UNEQUAL.to_owned(),
            "method = 'taylor'",
            "Taylor series, 1e-12 a step",
        ),
        (
            UNEQUAL.to_owned(),
            "method = 'rk4'\nstep = 0.01",
            "RK4, step 1e-2 s",
        ),
    ];
    for (body, run, method) in cases {
        assert_eq!(
            explained(&body, run).way.to_string(),
            method,
            "{body} {run}"
        );
    }
}

#[test]
fn work_is_skipped_where_nothing_needs_it_and_only_there() {
    let free = explained(UNEQUAL, "");
    for what in [
        "integration",
        "products of inertia",
        "trajectory",
        "Jacobian",
    ] {
        assert!(skips(&free).contains(&what), "{what}: {:?}", skips(&free));
    }
    let asked = explained(
        UNEQUAL,
        "outputs = ['trajectory', 'jacobian']\nwrt = ['attitude', 'inertia', 'dt']",
    );
    for what in [
        "trajectory storage",
        "Jacobian in the attitude",
        "Jacobian in the duration",
        "Jacobian columns",
    ] {
        assert!(skips(&asked).contains(&what), "{what}: {:?}", skips(&asked));
    }
    assert!(!skips(&asked).contains(&"Jacobian") && !skips(&asked).contains(&"trajectory"));
    let top = explained(
        &format!("{UNEQUAL}\ntorque = {{ kind = 'gravity', weight = 1, arm = [0, 0, 1] }}"),
        "outputs = ['jacobian']",
    );
    assert!(!skips(&top).contains(&"integration"));
    assert!(
        !skips(&top).contains(&"Jacobian in the attitude"),
        "gravity looks at the attitude"
    );
}

#[test]
fn the_attitude_is_left_out_where_the_energy_alone_is_asked_for_and_the_torque_is_blind() {
    let law = |torque: &str| format!("{UNEQUAL}\ntorque = {{ {torque} }}");
    let blind = law("kind = 'constant', value = [0.1, 0.2, 0]");
    let seeing = law("kind = 'constant', frame = 'space', value = [0.1, 0.2, 0]");
    let energy = "outputs = ['energy']";
    assert!(skips(&explained(&blind, energy)).contains(&"attitude"));
    assert!(!skips(&explained(&seeing, energy)).contains(&"attitude"));
    for outputs in [
        "outputs = ['energy', 'final']",
        "outputs = ['energy', 'momentum']",
    ] {
        assert!(!skips(&explained(&blind, outputs)).contains(&"attitude"));
    }
}

#[test]
fn the_costs_of_a_machine_decide_which_method_is_cheapest() {
    let text = format!(
        "[[body]]\nname = 'a'\n{UNEQUAL}\ntorque = {{ kind = 'damping', coefficient = 0.1 }}\n\
         [run]\nduration = 10\n"
    );
    let mut scene = scene::read(&Source::new("scene.toml", text)).expect("a good scene");
    let name = |scene: &scene::Scene| {
        let found = explain(&scene.groups[0], &scene.run).expect("a plan");
        found.way.to_string()
    };
    assert!(name(&scene).starts_with("Taylor"));
    let slow = Costs::default()
        .to_string()
        .replace("taylor = [", "taylor = [9e9, 9e9, 9e9, 9e9, 9e9] # ");
    scene.run.costs = Costs::read(&Source::new("costs.toml", slow)).expect("costs");
    assert!(name(&scene).starts_with("DOP853"));
    for (wrong, said) in [
        ("", "needs the key `taylor`"),
        ("taylor = [1, 2]", "there have to be 5"),
        ("taylor = [1, 2, 3, 4, -5]", "has to be positive"),
        ("tailor = [1]", "write `taylor`"),
        ("taylor = [", ""),
    ] {
        let errors = Costs::read(&Source::new("costs.toml", wrong)).expect_err("no costs");
        let found = errors
            .iter()
            .any(|e| format!("{} {:?}", e.message, e.helps).contains(said));
        assert!(found, "{wrong}: {errors:?}");
    }
}

#[test]
fn members_share_what_is_the_same_for_all() {
    let many = explained(&format!("{UNEQUAL}\ncount = 50"), "");
    assert!(skips(&many).contains(&"principal axes"));
    let drawn = "inertia = { xx = { from = 2, to = 2.5 }, yy = 3, zz = 4 }\nangular_velocity = [0.1, 3, 0]\ncount = 50";
    assert!(!skips(&explained(drawn, "")).contains(&"principal axes"));
}

#[test]
fn a_closed_form_that_is_asked_for_and_not_there_is_refused() {
    let text = format!(
        "[[body]]\nname = 'a'\n{UNEQUAL}\ntorque = {{ kind = 'damping', coefficient = 0.1 }}\n\
         [run]\nduration = 10\nmethod = 'exact'\n"
    );
    let scene = scene::read(&Source::new("scene.toml", text)).expect("a good scene");
    let refused = explain(&scene.groups[0], &scene.run).expect_err("no closed form");
    assert!(refused.to_string().contains("`exact` is for a free body"));
}
