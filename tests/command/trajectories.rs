//! Trajectories as Parquet, read back and held against the CSV.

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};

fn run(folder: &Path, format: &str) {
    let output = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["run", "scene.toml", "--format", format, "--out"])
        .arg(format!("result.{format}"))
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{output:?}");
}

/// The fields of a row as the CSV writes them.
fn written(field: &Field) -> String {
    match field {
        Field::Str(text) => text.clone(),
        Field::Double(number) => format!("{number:e}"),
        Field::Null => String::new(),
        other => panic!("no such type: {other:?}"),
    }
}

#[test]
fn the_file_has_the_numbers_of_the_csv() {
    for outputs in ["'trajectory'", "'final'"] {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = format!(
            "[[body]]\nname = 'satellite'\ncount = 3\ninertia = {{ xx = 2, yy = 3, zz = 4 }}\n\
             angular_velocity = [{{ from = 0.1, to = 1.0 }}, 3, 0]\n\
             torque = {{ kind = 'damping', coefficient = 0.1 }}\n\
             [run]\nduration = 2\noutput_interval = 4e-5\noutputs = [{outputs}]\n"
        );
        fs::write(folder.path().join("scene.toml"), scene).expect("written");
        run(folder.path(), "csv");
        run(folder.path(), "parquet");
        let csv = fs::read_to_string(folder.path().join("result.csv")).expect("a result");
        let file = File::open(folder.path().join("result.parquet")).expect("a result");
        let reader = SerializedFileReader::new(file).expect("a complete file");
        // More rows than are gathered at a time.
        let groups = if outputs == "'final'" { 1 } else { 2 };
        assert_eq!(reader.num_row_groups(), groups);
        let mut lines = csv.lines();
        let head: Vec<_> = lines.next().expect("a head").split(',').collect();
        for row in reader.get_row_iter(None).expect("rows") {
            let row = row.expect("a row");
            let names: Vec<_> = row
                .get_column_iter()
                .map(|(name, _)| name.as_str())
                .collect();
            assert_eq!(names, head);
            let line = lines.next().expect("as many rows");
            for ((_, found), text) in row.get_column_iter().zip(line.split(',')) {
                let same = match text.parse::<f64>() {
                    Ok(number) => written(found) == format!("{number:e}"),
                    Err(_) => written(found) == text,
                };
                assert!(same, "{found:?}, {text}");
            }
        }
        assert_eq!(lines.next(), None);
        let others = fs::read_dir(folder.path()).expect("readable").count();
        assert_eq!(others, 3, "nothing but the scene and its results");
    }
}
