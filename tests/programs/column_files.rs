//! Points from Parquet and Arrow files, and verdicts to them. Most of this needs `cargo test --features columnar`.

#![cfg_attr(
    feature = "columnar",
    expect(clippy::unwrap_used, reason = "a test fails by panicking")
)]

use std::fs;

use tempfile::TempDir;

use crate::common::program::run_in;

#[cfg(not(feature = "columnar"))]
#[test]
fn files_of_columns_need_their_feature() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("p.parquet"), "PAR1").unwrap();
    let all: [&[&str]; 2] = [
        &["--points", "p.parquet"],
        &["--point", "1,0", "-o", "out.arrow"],
    ];
    for arguments in all {
        let start = ["inspect", "x^2+y^2=1", "--tolerance", "1"];
        let run = run_in(folder.path(), &[&start[..], arguments].concat(), "");
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(run.err.contains("--features columnar"), "{}", run.err);
        assert_eq!(run.err.lines().count(), 1, "{}", run.err);
        assert!(!folder.path().join("out.arrow").exists());
    }
}

#[cfg(feature = "columnar")]
mod with_columns {
    use super::*;
    use std::fs::File;
    use std::path::Path;
    use std::sync::Arc;

    use arrow::array::{
        Array, ArrayRef, BooleanArray, Float64Array, Int8Array, Int64Array, ListArray, RecordBatch,
        StringArray,
    };
    use arrow::compute::concat_batches;
    use arrow::datatypes::Int32Type;
    use arrow::ipc::reader::FileReader;
    use arrow::ipc::writer::{FileWriter, StreamWriter};
    use parquet::arrow::ArrowWriter;
    use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

    /// Points about the unit sphere, with their columns in another order, a number, a text and a list for each.
    fn table() -> RecordBatch {
        let numbers = |list: [f64; 4]| Arc::new(Float64Array::from(list.to_vec())) as ArrayRef;
        let names = [Some("mm"), Some("a, \"b\""), None, Some("µm")];
        let lists = [
            Some(vec![Some(1)]),
            None,
            Some(vec![]),
            Some(vec![Some(2), None]),
        ];
        RecordBatch::try_from_iter([
            ("z", numbers([0.0, 1.1, 0.1, 0.0])),
            ("unit", Arc::new(StringArray::from(names.to_vec()))),
            ("y", numbers([0.9, 0.0, 1.0, 0.0])),
            (
                "tags",
                Arc::new(ListArray::from_iter_primitive::<Int32Type, _, _>(lists)),
            ),
            (
                "id",
                Arc::new(Int64Array::from(vec![
                    Some(9_007_199_254_740_993),
                    Some(-2),
                    None,
                    Some(4),
                ])),
            ),
            ("x", numbers([0.0, 0.0, 0.1, 3.0])),
            (
                "good",
                Arc::new(BooleanArray::from(vec![
                    Some(true),
                    Some(false),
                    None,
                    Some(true),
                ])),
            ),
        ])
        .unwrap()
    }

    fn read(path: &Path) -> RecordBatch {
        let file = File::open(path).unwrap();
        let batches: Vec<RecordBatch> = if path.extension().unwrap() == "parquet" {
            let reader = ParquetRecordBatchReaderBuilder::try_new(file)
                .unwrap()
                .build()
                .unwrap();
            reader.map(Result::unwrap).collect()
        } else {
            FileReader::try_new(file, None)
                .unwrap()
                .map(Result::unwrap)
                .collect()
        };
        concat_batches(&batches[0].schema(), &batches).unwrap()
    }

    fn column<'b, T: 'static>(batch: &'b RecordBatch, name: &str) -> &'b T {
        let column = batch.column_by_name(name).unwrap();
        column.as_any().downcast_ref().unwrap()
    }

    /// Every kind of file is read, and every kind is written, with the columns that are carried along in their types.
    #[test]
    fn columns_come_in_and_go_out() {
        let folder = TempDir::new().unwrap();
        let table = table();
        let create = |name: &str| File::create(folder.path().join(name)).unwrap();
        let mut parquet = ArrowWriter::try_new(create("p.parquet"), table.schema(), None).unwrap();
        parquet.write(&table).unwrap();
        parquet.close().unwrap();
        let mut arrow = FileWriter::try_new(create("p.feather"), &table.schema()).unwrap();
        arrow.write(&table.slice(0, 1)).unwrap();
        arrow.write(&table.slice(1, 3)).unwrap();
        arrow.finish().unwrap();
        let mut stream = StreamWriter::try_new(create("p.arrows"), &table.schema()).unwrap();
        stream.write(&table).unwrap();
        stream.finish().unwrap();
        for from in ["p.parquet", "p.feather", "p.arrows"] {
            for to in ["out.parquet", "out.arrow", "out.csv"] {
                let run = run_in(
                    folder.path(),
                    &[
                        "inspect",
                        "x^2+y^2+z^2=1",
                        "--tolerance",
                        "0.1",
                        "--points",
                        from,
                        "--keep",
                        "-o",
                        to,
                    ],
                    "",
                );
                assert_eq!(run.code, 1, "{}", run.err);
                assert!(
                    run.err.contains("4 points: 3 inside, 1 outside"),
                    "{}",
                    run.err
                );
            }
            let text = fs::read_to_string(folder.path().join("out.csv")).unwrap();
            let mut lines = text.lines();
            let head = "x,y,z,verdict,curve,distance_low,distance_high,sign,unit,id,good";
            assert_eq!(lines.next(), Some(head));
            assert!(
                lines
                    .next()
                    .unwrap()
                    .ends_with(",-1,mm,9007199254740993,true")
            );
            for to in ["out.parquet", "out.arrow"] {
                let found = read(&folder.path().join(to));
                let names: Vec<_> = found
                    .schema()
                    .fields()
                    .iter()
                    .map(|f| f.name().clone())
                    .collect();
                assert_eq!(names.join(","), head);
                assert_eq!(
                    column::<Float64Array>(&found, "x"),
                    column::<Float64Array>(&table, "x")
                );
                for name in ["y", "z"] {
                    assert_eq!(
                        column::<Float64Array>(&found, name),
                        column::<Float64Array>(&table, name)
                    );
                }
                assert_eq!(
                    column::<Int64Array>(&found, "id"),
                    column::<Int64Array>(&table, "id")
                );
                assert_eq!(
                    column::<BooleanArray>(&found, "good"),
                    column::<BooleanArray>(&table, "good")
                );
                assert_eq!(
                    column::<StringArray>(&found, "unit"),
                    column::<StringArray>(&table, "unit")
                );
                let verdicts: Vec<_> = column::<StringArray>(&found, "verdict")
                    .iter()
                    .flatten()
                    .collect();
                assert_eq!(verdicts, ["inside", "inside", "inside", "outside"]);
                let curve = column::<BooleanArray>(&found, "curve");
                assert_eq!(curve, &BooleanArray::from(vec![true, true, true, false]));
                assert_eq!(
                    column::<Int8Array>(&found, "sign"),
                    &Int8Array::from(vec![-1, 1, 1, 1])
                );
                let distance = column::<Float64Array>(&found, "distance_low").value(3);
                assert!((distance - 2.0).abs() < 1e-6);
            }
        }
    }

    /// More rows than a batch has give the numbers that CSV gives, in their order.
    #[test]
    fn long_files_have_the_numbers_of_csv() {
        let folder = TempDir::new().unwrap();
        let rows: Vec<String> = (0..20_000)
            .map(|k| format!("{},{}", f64::from(k) * 1e-4, 0.5))
            .collect();
        fs::write(folder.path().join("p.csv"), rows.join("\n")).unwrap();
        for to in ["out.csv", "out.parquet", "out.arrow"] {
            let run = run_in(
                folder.path(),
                &[
                    "inspect",
                    "x^2+y^2=1",
                    "--tolerance",
                    "0.25",
                    "--points",
                    "p.csv",
                    "-o",
                    to,
                ],
                "",
            );
            assert_eq!(run.code, 1, "{}", run.err);
        }
        let text = fs::read_to_string(folder.path().join("out.csv")).unwrap();
        for to in ["out.parquet", "out.arrow"] {
            let found = read(&folder.path().join(to));
            assert_eq!(found.num_rows(), 20_000);
            let highs = column::<Float64Array>(&found, "distance_high");
            let verdicts = column::<StringArray>(&found, "verdict");
            for (k, line) in text.lines().skip(1).enumerate() {
                let fields: Vec<&str> = line.split(',').collect();
                assert_eq!(verdicts.value(k), fields[2]);
                assert_eq!(
                    highs.value(k).to_bits(),
                    fields[5].parse::<f64>().unwrap().to_bits()
                );
            }
        }
    }

    /// What is wrong is one clear error, and nothing is written.
    #[test]
    fn wrong_files_are_refused() {
        let folder = TempDir::new().unwrap();
        let table = table();
        let create = |name: &str| File::create(folder.path().join(name)).unwrap();
        let mut whole =
            ArrowWriter::try_new(create("whole.parquet"), table.schema(), None).unwrap();
        whole.write(&table).unwrap();
        whole.close().unwrap();
        let bytes = fs::read(folder.path().join("whole.parquet")).unwrap();
        fs::write(folder.path().join("cut.parquet"), &bytes[..bytes.len() / 2]).unwrap();
        fs::write(folder.path().join("text.arrow"), "x,y,z\n1,2,3\n").unwrap();
        fs::write(folder.path().join("empty.parquet"), "").unwrap();
        // Points must have names, and a point has no null coordinate.
        let named = RecordBatch::try_from_iter([
            ("a", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
            ("b", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
            ("c", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
            ("d", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
        ])
        .unwrap();
        let lacking = RecordBatch::try_from_iter([
            (
                "x",
                Arc::new(Float64Array::from(vec![Some(1.0), None])) as ArrayRef,
            ),
            (
                "y",
                Arc::new(Float64Array::from(vec![1.0, 2.0])) as ArrayRef,
            ),
            (
                "z",
                Arc::new(Float64Array::from(vec![1.0, 2.0])) as ArrayRef,
            ),
        ])
        .unwrap();
        for (name, table) in [("named.arrow", &named), ("lacking.arrow", &lacking)] {
            let mut writer = FileWriter::try_new(create(name), &table.schema()).unwrap();
            writer.write(table).unwrap();
            writer.finish().unwrap();
        }
        for name in [
            "cut.parquet",
            "text.arrow",
            "empty.parquet",
            "named.arrow",
            "lacking.arrow",
        ] {
            let run = run_in(
                folder.path(),
                &[
                    "inspect",
                    "x^2+y^2+z^2=1",
                    "--tolerance",
                    "1",
                    "--points",
                    name,
                    "-o",
                    "out.parquet",
                ],
                "",
            );
            assert_eq!(run.code, 2, "{name}: {}", run.err);
            assert!(
                run.err.contains(name) && run.err.lines().count() == 1,
                "{name}: {}",
                run.err
            );
            assert!(!folder.path().join("out.parquet").exists(), "{name}");
        }
        let run = run_in(
            folder.path(),
            &[
                "inspect",
                "x^2+y^2=1",
                "--tolerance",
                "1",
                "--point",
                "1,0",
                "--format",
                "json",
                "-o",
                "out.arrow",
            ],
            "",
        );
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(run.err.contains("leave --format out"), "{}", run.err);
    }
}
