//! `polhode run` as a user sees it.

use super::start::polhode;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Output;

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

#[test]
fn every_example_runs_within_its_tolerance() {
    for name in [
        "t-handle",
        "sphere",
        "needle",
        "heavy-top",
        "damped-satellite",
        "ensemble",
        "robot-arm",
    ] {
        let path = format!("examples/scenes/{name}.toml");
        let output = polhode(Path::new("."), &["run", "--format", "json", &path]);
        assert_eq!(
            code(&output),
            Some(0),
            "{name}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        let form: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(form["schema"], "polhode-run/1");
        let tolerance = form["run"]["tolerance"].as_f64().expect("a tolerance");
        let bodies = form["bodies"].as_array().expect("bodies");
        assert_eq!(
            bodies.len(),
            if name == "ensemble" {
                100_000
            } else {
                bodies.len().min(2)
            }
        );
        for body in bodies {
            let error = body["error_estimate"].as_f64().expect("an estimate");
            assert!(error <= tolerance, "{name}: {error:e}");
            let drift = body["energy_drift"].as_f64().unwrap_or(0.0);
            assert!(drift <= tolerance, "{name}: the energy drifts by {drift:e}");
            let q: Vec<f64> =
                serde_json::from_value(body["attitude"].clone()).expect("four numbers");
            assert!((q.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn the_jacobian_has_the_blocks_that_were_asked_for() {
    let output = polhode(
        Path::new("."),
        &["run", "--format", "json", "examples/scenes/heavy-top.toml"],
    );
    let form: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let jacobian = form["bodies"][0]["jacobian"].as_object().expect("blocks");
    assert_eq!(
        jacobian.keys().collect::<Vec<_>>(),
        ["angular_velocity", "torque"]
    );
    let rows: Vec<[f64; 3]> = serde_json::from_value(jacobian["torque"].clone()).expect("6 × 3");
    assert_eq!(rows.len(), 6);
}

#[test]
fn a_trajectory_is_a_row_for_each_output_time() {
    let output = polhode(
        Path::new("."),
        &["run", "--format", "csv", "examples/scenes/heavy-top.toml"],
    );
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines[0], "body,time,qw,qx,qy,qz,wx,wy,wz,energy");
    assert_eq!(lines.len(), 102);
    assert!(lines[101].starts_with("top,10,"), "{}", lines[101]);
    assert!(lines.iter().all(|line| line.split(',').count() == 10));
}

#[test]
fn an_attitude_that_nobody_asks_for_is_not_made_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = "[[body]]\nname = 'a'\ninertia = { xx = 2, yy = 3, zz = 4, xy = 0.1 }\n\
                 angular_velocity = [1, 3, 0.2]\ntorque = { kind = 'damping', coefficient = 0.1 }\n\
                 [run]\nduration = 10\noutputs = [";
    let body = |outputs: &str| {
        let text = format!("{scene}{outputs}]\n");
        fs::write(folder.path().join("a.toml"), text).expect("written");
        let output = polhode(folder.path(), &["run", "--format", "json", "a.toml"]);
        assert_eq!(code(&output), Some(0));
        let form: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        form["bodies"][0].clone()
    };
    let (energy, both) = (body("'energy'"), body("'energy', 'final'"));
    assert!(energy["attitude"].is_null() && both["attitude"].is_array());
    for k in 0..3 {
        let of = |form: &Value| form["angular_velocity"][k].as_f64().expect("a number");
        assert!((of(&energy) - of(&both)).abs() < 1e-10);
    }
}

#[test]
fn a_bad_scene_ends_with_2_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(
        folder.path().join("bad.toml"),
        "[[body]]\nname = 'a'\ninertai = 1\n",
    )
    .expect("written");
    let output = polhode(folder.path(), &["run", "bad.toml", "--out", "result.json"]);
    assert_eq!(code(&output), Some(2));
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(
        said.contains("--> bad.toml:3:1") && said.contains("write `inertia`"),
        "{said}"
    );
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1);
}

#[test]
fn a_tolerance_that_cannot_be_kept_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    // So close to the separatrix that the phase of the flip hangs on the last bits.
    let scene = "[[body]]\nname = 'handle'\ninertia = { xx = 2, yy = 3, zz = 4 }\n\
                 angular_velocity = [0, 3, 1e-6]\n[run]\nduration = 100\ntolerance = 1e-13\n";
    fs::write(folder.path().join("handle.toml"), scene).expect("written");
    let output = polhode(folder.path(), &["run", "handle.toml"]);
    assert_eq!(code(&output), Some(3));
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(said.contains("\"handle\" may be off by up to"), "{said}");
}

#[test]
fn the_plan_is_explained_as_text_and_json() {
    let path = "examples/scenes/ensemble.toml";
    let text = polhode(Path::new("."), &["explain", path]);
    assert_eq!(code(&text), Some(0));
    let text = String::from_utf8(text.stdout).expect("UTF-8");
    assert!(
        text.starts_with("throw × 100000\n")
            && text.contains("  method    closed form, free body\n"),
        "{text}"
    );
    let output = polhode(Path::new("."), &["explain", "--format", "json", path]);
    let form: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(form["schema"], "polhode-explain/1");
    assert_eq!(form["bodies"][0]["skipped"][0]["what"], "integration");
}

#[test]
fn a_body_is_drawn() {
    for (name, body) in [
        ("t-handle", "T-handle"),
        ("damped-satellite", "shaken"),
        ("sphere", "ball"),
    ] {
        let path = format!("examples/scenes/{name}.toml");
        let output = polhode(Path::new("."), &["plot", "--body", body, &path]);
        assert_eq!(
            code(&output),
            Some(0),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        let svg = String::from_utf8(output.stdout).expect("UTF-8");
        assert!(
            svg.starts_with("<svg") && svg.contains("herpolhode") && !svg.contains("NaN"),
            "{name}"
        );
    }
    let output = polhode(
        Path::new("."),
        &["plot", "--body", "nobody", "examples/scenes/sphere.toml"],
    );
    assert_eq!(code(&output), Some(2));
}

#[test]
fn a_bench_has_its_table_and_its_diagrams() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = [
        "bench",
        "--quick",
        "--problem",
        "damped",
        "--format",
        "csv",
        "--diagrams",
        "d",
    ];
    let output = polhode(folder.path(), &arguments);
    assert_eq!(
        code(&output),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(
        text.lines()
            .any(|line| line.starts_with("\"damped\",\"ode_solvers DOP853\",1e-9,")),
        "{text}"
    );
    let svg =
        fs::read_to_string(folder.path().join("d/work-precision-damped.svg")).expect("a diagram");
    assert!(svg.contains("ode_solvers DOP853") && !svg.contains("NaN"));
    let output = polhode(folder.path(), &["bench", "--problem", "nothing"]);
    assert_eq!(code(&output), Some(2));
}
