//! Arrays of every kind of number are read, and what is no outline is named.

use super::*;

/// An array as `numpy.save` writes it.
fn array(version: u8, description: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let mut header =
        format!("{{'descr': {description}, 'fortran_order': {order}, 'shape': {shape}, }}");
    header.push_str(&" ".repeat(63 - header.len() % 64));
    header.push('\n');
    let length = header.len();
    let mut bytes = [MAGIC, &[version, 0]].concat();
    match version {
        1 => bytes.extend(u16::try_from(length).unwrap().to_le_bytes()),
        _ => bytes.extend(u32::try_from(length).unwrap().to_le_bytes()),
    }
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

fn bytes<const N: usize>(numbers: &[i8], write: impl Fn(i8) -> [u8; N]) -> Vec<u8> {
    numbers.iter().flat_map(|&n| write(n)).collect()
}

#[test]
fn every_number_in_every_order_is_read() {
    let rows: [i8; 6] = [0, -1, 5, 2, -3, 4];
    let by_columns: [i8; 6] = [0, 5, -3, -1, 2, 4];
    let expected = [[0.0, -1.0], [5.0, 2.0], [-3.0, 4.0]];
    let read = |bytes: &[u8]| {
        read_array(bytes, &OutlineOptions::default(), "a.npy")
            .unwrap()
            .points
    };
    for version in 1..=3 {
        for (kind, data) in [
            ("'<f4'", bytes(&rows, |n| f32::from(n).to_le_bytes())),
            ("'>f4'", bytes(&rows, |n| f32::from(n).to_be_bytes())),
            ("'<f8'", bytes(&rows, |n| f64::from(n).to_le_bytes())),
            ("'>f8'", bytes(&rows, |n| f64::from(n).to_be_bytes())),
            ("'|i1'", bytes(&rows, i8::to_le_bytes)),
            ("'<i2'", bytes(&rows, |n| i16::from(n).to_le_bytes())),
            ("'>i2'", bytes(&rows, |n| i16::from(n).to_be_bytes())),
            ("'<i4'", bytes(&rows, |n| i32::from(n).to_le_bytes())),
            ("\">i8\"", bytes(&rows, |n| i64::from(n).to_be_bytes())),
        ] {
            for shape in ["(3, 2)", "(3, 1, 2)", "(3L, 2L)"] {
                assert_eq!(read(&array(version, kind, "False", shape, &data)), expected);
            }
        }
        let data = bytes(&by_columns, |n| f64::from(n).to_le_bytes());
        assert_eq!(
            read(&array(version, "'<f8'", "True", "(3, 2)", &data)),
            expected
        );
        let data = bytes(&rows, |n| f32::from(n).to_be_bytes());
        assert_eq!(
            read(&array(version, "'>c8'", "True", "(3,)", &data)),
            expected
        );
        let data = bytes(&rows, |n| f64::from(n).to_le_bytes());
        assert_eq!(
            read(&array(version, "'<c16'", "False", "(3,)", &data)),
            expected
        );
    }
    let large = [u64::MAX.to_le_bytes(), 200_u64.to_le_bytes()].concat();
    let large = array(1, "'<u8'", "False", "(1, 2)", &large);
    assert_eq!(read(&large), [[18_446_744_073_709_551_615.0, 200.0]]);
    let small = array(1, "'|u1'", "False", "(1, 2)", &[200, 255]);
    assert_eq!(read(&small), [[200.0, 255.0]]);
    let three = array(1, "'|u1'", "False", "(2, 3)", &[7, 1, 2, 8, 3, 4]);
    let columns = OutlineOptions::default().columns("2,3".parse().ok());
    let chosen = read_array(&three, &columns, "a.npy").unwrap();
    assert_eq!(chosen.points, [[1.0, 2.0], [3.0, 4.0]]);
    let weighted = columns.weights("1".parse().ok());
    let chosen = read_array(&three, &weighted, "a.npy").unwrap();
    assert_eq!(
        (chosen.points[1], &chosen.weights[..]),
        ([3.0, 4.0], &[7.0, 8.0][..])
    );
}

#[test]
fn what_is_no_outline_is_named() {
    let zeros = [0; 96];
    let any =
        |kind: &str, shape: &str, length: usize| array(1, kind, "False", shape, &zeros[..length]);
    for (bytes, part) in [
        (
            any("'<f8'", "(4, 3)", 96),
            "--columns 1,2 says which columns",
        ),
        (any("'|u1'", "(2, 9)", 18), "a.T"),
        (any("'|u1'", "(9, 10)", 90), "if it is a picture"),
        (any("'|u1'", "(3,)", 3), "the shape (3,)"),
        (any("'|u1'", "()", 1), "the shape ()"),
        (any("'|O'", "(3, 2)", 48), "objects of Python"),
        (any("'|b1'", "(3, 2)", 6), "truth values"),
        (any("'<f2'", "(3, 2)", 12), "astype"),
        (any("'<U3'", "(3, 2)", 72), "texts"),
        (
            any("[('x', '<f8'), ('y', '<f8')]", "(3,)", 48),
            "column_stack",
        ),
        (
            any("'<f8'", "(3, 2)", 47),
            "48 bytes of elements; the file has 47",
        ),
        (
            any("'<f8'", "(3, 2)", 49),
            "48 bytes of elements; the file has 49",
        ),
        (
            any("'<f8'", "(18446744073709551615, 2)", 48),
            "too many bytes",
        ),
        (any("'<f8'", "(99999999999999999999, 2)", 48), "is damaged"),
        (any("'<f8'", "3", 48), "is damaged"),
        (array(4, "'<f8'", "False", "(3, 2)", &[]), "version 4"),
        (b"x,y\n1,2\n".to_vec(), "this is no NumPy array"),
        (
            any("'<f8'", "(3, 2)", 48)[..40].to_vec(),
            "ends in the header",
        ),
    ] {
        let error = read_array(&bytes, &OutlineOptions::default(), "a.npy")
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("a.npy: ") && error.contains(part),
            "{error}"
        );
    }
    let empty = any("'<f8'", "(0, 2)", 0);
    assert!(
        read_array(&empty, &OutlineOptions::default(), "a.npy")
            .unwrap()
            .points
            .is_empty()
    );
}
