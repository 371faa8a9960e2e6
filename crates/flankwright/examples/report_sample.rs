//! Writes sample reports with made-up data, for looking at charts and page without running a plan:
//! `cargo run --example report_sample -- DIR`

#[path = "../tests/report_sample/mod.rs"]
mod report_sample;

use flankwright::report::html;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let directory = std::env::args().nth(1).ok_or("usage: report_sample DIR")?;
    let directory = std::path::Path::new(&directory);
    std::fs::create_dir_all(directory)?;
    let samples = [
        ("met", report_sample::met()),
        ("missed", report_sample::missed()),
        ("not-producible", report_sample::not_producible()),
    ];
    for (name, report) in samples {
        let file = directory.join(format!("{name}.html"));
        std::fs::write(&file, html::render(&report.to_page()?))?;
        println!("{}", file.display());
    }
    Ok(())
}
