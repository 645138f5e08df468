package org.u2sa.estimation.fusion;

/**
 * Error-state extended Kalman filter (Solà 2017, arXiv 1711.02508) over whatever sources there are:
 * each is known by its name only, from its first measurement on. Measurements may come late and in
 * any order: they are fused where they belong in time, and all later ones again after them, as soon
 * as somebody asks. So of several that come late before that, each is fused again once only.
 *
 * <p>Belongs to one thread. Allocates nothing once all sources are known.
 */
public final class ErrorStateFilter {
  private static final double LONGEST_GAP_S = 600.0;

  /** What became of a measurement. */
  public enum Outcome {
    /** It is the newest. */
    FUSED,
    /** It was late and is put into its place. */
    REPLAYED,
    /** It was older than the horizon, and is lost. */
    TOO_LATE
  }

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final ProcessModel process;
  private final Fuser fuser;
  private final History history;
  private final long horizonMicros;
  private final FilterState ahead = new FilterState();
  private final MeasurementModel look = new MeasurementModel();
  private long late;
  private long replayed;

  /** A filter that knows nothing yet. */
  public ErrorStateFilter(FilterTuning tuning) {
    this.tuning = tuning;
    trust = new SourceTrust(tuning.window());
    process = new ProcessModel(tuning);
    fuser = new Fuser(tuning, trust, process);
    history = new History(tuning.history());
    horizonMicros = (long) Math.ceil(tuning.horizonS() * 1e6);
  }

  /** Takes a measurement, which is copied. */
  public Outcome add(Measurement m) {
    double ageS = history.isStarted() ? (micros() - m.micros()) * 1e-6 : 0.0;
    if (ageS > tuning.horizonS()) {
      late++;
      return Outcome.TOO_LATE;
    }
    if (-ageS > LONGEST_GAP_S) {
      history.restart(new FilterState());
    }
    if (history.isFull() && history.fused() == 0) {
      fuse(); // the state after the oldest is what remains of it
    }
    history.forget(micros() - horizonMicros);
    int source = trust.source(m.source());
    int index = history.insert(m, source);
    if (index < 0) {
      late++;
      return Outcome.TOO_LATE;
    }
    boolean isNewest = index == history.count() - 1;
    replayed += isNewest ? 0 : 1;
    return isNewest ? Outcome.FUSED : Outcome.REPLAYED;
  }

  private void fuse() {
    for (int i = history.fused(); i < history.count(); i++) {
      History.Entry entry = history.at(i);
      fuser.fuse(history.after(i), entry.measurement, entry.source);
    }
    history.allFused();
  }

  /** The estimate, carried ahead to that time [µs] if it is later than the newest measurement. */
  public Estimate at(long micros) {
    ahead.copyFrom(state());
    if (ahead.isStarted) {
      process.predict(ahead, micros);
    }
    return new Estimate(ahead, look, tuning);
  }

  /** Time of the newest measurement [µs]. */
  public long micros() {
    return history.micros();
  }

  /** Measurements that were older than the horizon. */
  public long late() {
    return late;
  }

  /** Measurements that came late, and were fused where they belong. */
  public long replayed() {
    return replayed;
  }

  /** How often a quantity began anew because all its sources contradicted it. */
  public long resets() {
    return state().resets;
  }

  /** What is known of the sources. */
  public SourceReports sources() {
    return new SourceReports(state(), trust, tuning);
  }

  SourceTrust trust() {
    return trust;
  }

  /** The state after the newest measurement. */
  FilterState state() {
    fuse();
    return history.before(history.count());
  }

  /** Goes on from another state, as after a restart. */
  void resume(FilterState from) {
    history.restart(from);
  }
}
