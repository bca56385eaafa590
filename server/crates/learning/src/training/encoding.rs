//! From demonstrations to the motion they have in common, by either method.

use crate::{
    Demonstration, Error, Path, TrainingParams,
    agreement::{Agreement, agreement},
    alignment::{self, Aligned, barycentre, centre},
    metrics::Kinetics,
    mixture::{self, Mixture, Rows},
    progress::{Counter, Report, Stage},
    regression::{Course, Ends, Regression},
    rng::Stream,
    selection::{self, LeftOut, Stability},
    signals::{self, ModelSignal},
};

const STREAM_MIXTURE: u64 = 2;
/// Over this share of the motion, and at most this long, the regression is led to
/// its ends, and gathers and loses speed.
const END_SHARE: f64 = 0.1;
const END_LONGEST_S: f64 = 1.0;

/// The motion that demonstrations have in common, and how it was found.
pub struct Encoding {
    /// Demonstration that gave (paper) or began (faithful) the time axis.
    pub reference: usize,
    pub k: usize,
    pub js: Vec<Stability>,
    pub left_out: Vec<LeftOut>,
    pub mixture: Mixture,
    pub course: Course,
    pub regression: Regression,
    /// Mean of the aligned demonstrations.
    pub middle_deg: Path,
    pub agreement: Agreement,
    /// The signals that the demonstrations work alike.
    pub signals: Vec<ModelSignal>,
}

/// The paper: one reference, k by the stability of random halves, EM from k-means.
pub fn by_the_paper(
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    progress: Report,
) -> Result<Encoding, Error> {
    let m = demonstrations.len();
    let counter = Counter::begin(progress, Stage::Alignment, m * (m - 1) / 2 + m - 1)?;
    let (aligned, clocks_s) =
        alignment::align_with_clocks(demonstrations, params.rate_hz, &mut |_, _| counter.step())?;
    let (values, width) = all_rows(&aligned);
    let rows = Rows::new(width, &values);

    // A very short recording may not hold as many components as the protocol asks for.
    let mut range = params.selection.clone();
    range.k_max = range.k_max.min(rows.len() / 4).max(range.k_min);
    let total = (range.k_max - range.k_min + 1) * range.splits;
    let counter = Counter::begin(progress, Stage::Selection, total)?;
    let js = selection::stabilities(rows, &range, params.seed, &|| counter.step())?;
    let k = selection::choose(&js);

    Counter::begin(progress, Stage::Mixture, 1)?;
    let mut rng = Stream::derive(params.seed, &[STREAM_MIXTURE]);
    let mixture = mixture::fit(rows, &rows.by_time(), k, &mut rng)?.mixture;
    Counter::begin(progress, Stage::Regression, 1)?;
    let course = Course {
        motion_s: aligned.duration_s(),
        rate_hz: params.rate_hz,
        ends: None,
    };
    let regression = course.regress(&mixture);
    Ok(Encoding {
        reference: aligned.reference,
        k,
        js,
        left_out: Vec::new(),
        mixture,
        agreement: agreement(demonstrations, &aligned),
        signals: signals::learned(demonstrations, &aligned.t_s, &clocks_s, &course),
        middle_deg: barycentre::mean_of(&aligned.joints_deg),
        course,
        regression,
    })
}

/// Faithful: the common mean, k by what a left-out demonstration would miss, EM
/// along time, at rest at both ends in the poses where the demonstrations began
/// and ended.
pub fn faithfully(
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    progress: Report,
) -> Result<Encoding, Error> {
    let m = demonstrations.len();
    let steps = barycentre::steps(m);
    let counter = Counter::begin(progress, Stage::Alignment, steps)?;
    let barycentre =
        barycentre::align_to_mean(demonstrations, params.rate_hz, &mut |_, _| counter.step())?;
    let aligned = &barycentre.aligned;

    // Each component needs some samples of each demonstration.
    let most = aligned.t_s.len() / 8;
    let mut candidates = params.candidates.clone();
    candidates.retain(|&k| k <= most.max(2));
    let total = candidates.len() * m;
    let counter = Counter::begin(progress, Stage::Selection, total)?;
    let tried = selection::leave_one_out(aligned, &candidates, params.seed, &|| counter.step())?;

    Counter::begin(progress, Stage::Mixture, 1)?;
    let aligned = centre::centred(aligned, &barycentre.clocks_s);
    let (values, width) = all_rows(&aligned);
    let course = Course {
        motion_s: aligned.duration_s(),
        rate_hz: params.rate_hz,
        ends: Some(ends(&aligned)),
    };
    let shown = Kinetics::of_all(demonstrations).peak_acceleration_deg_s2;
    let mut smoothest: Option<(f64, Fitted)> = None;
    for k in selection::by_missed(&tried) {
        let mixture = mixture::fit_along_time(Rows::new(width, &values), k)?.mixture;
        let regression = course.regress(&mixture);
        let dt_s = regression.t_s[1] - regression.t_s[0];
        let peak = Kinetics::of_path(&regression.mean_deg, dt_s).peak_acceleration_deg_s2;
        if smoothest.as_ref().is_none_or(|(least, _)| peak < *least) {
            let fitted = Fitted {
                k,
                mixture,
                regression,
            };
            smoothest = Some((peak, fitted));
        }
        if peak <= shown {
            break;
        }
    }
    let (_, fitted) = smoothest.ok_or(Error::NoDemonstrations)?;
    Counter::begin(progress, Stage::Regression, 1)?;
    Ok(Encoding {
        reference: aligned.reference,
        k: fitted.k,
        js: tried.iter().map(|t| t.stability.clone()).collect(),
        left_out: tried.into_iter().map(|t| t.left_out).collect(),
        mixture: fitted.mixture,
        agreement: agreement(demonstrations, &aligned),
        signals: signals::learned(
            demonstrations,
            &aligned.t_s,
            &barycentre.recorded_s(),
            &course,
        ),
        middle_deg: barycentre::mean_of(&aligned.joints_deg),
        course,
        regression: fitted.regression,
    })
}

/// A mixture of k components and the motion that it gives.
struct Fitted {
    k: usize,
    mixture: Mixture,
    regression: Regression,
}

fn all_rows(aligned: &Aligned) -> (Vec<f64>, usize) {
    let all: Vec<usize> = (0..aligned.joints_deg.len()).collect();
    (aligned.rows(&all), aligned.joints_deg[0].width() + 1)
}

/// The mean of the demonstrations' own ends.
fn ends(aligned: &Aligned) -> Ends {
    let mean = barycentre::mean_of(&aligned.joints_deg);
    let end_s = (END_SHARE * aligned.duration_s()).min(END_LONGEST_S);
    Ends {
        start_deg: mean.row(0).to_vec(),
        end_deg: mean.last().to_vec(),
        fade_s: end_s,
        ease_s: end_s,
    }
}
