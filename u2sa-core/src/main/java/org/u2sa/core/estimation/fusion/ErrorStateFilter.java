package org.u2sa.core.estimation.fusion;

/**
 * Error-state extended Kalman filter (Solà 2017, arXiv 1711.02508) over whatever sources there are:
 * each is known by its name only, from its first measurement on. Measurements may come late and in
 * any order: they are fused where they belong in time, and all later ones again after them.
 *
 * <p>Belongs to one thread. Allocates nothing once all sources are known.
 */
public final class ErrorStateFilter {
  private static final double LONGEST_GAP_S = 600.0;

  /** What became of a measurement. */
  public enum Outcome {
    /** It was the newest. */
    FUSED,
    /** It was late and put into its place. */
    REPLAYED,
    /** It was older than the horizon, and is lost. */
    TOO_LATE
  }

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final ProcessModel process;
  private final Fuser fuser;
  private final History history;
  private final FilterState now = new FilterState();
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
  }

  /** Fuses a measurement, which is copied. */
  public Outcome add(Measurement m) {
    double ageS = now.isStarted ? (now.micros - m.micros()) * 1e-6 : 0.0;
    if (ageS > tuning.horizonS()) {
      late++;
      return Outcome.TOO_LATE;
    }
    if (-ageS > LONGEST_GAP_S) {
      now.copyFrom(new FilterState());
      history.restart(now);
    }
    int source = trust.source(m.source());
    int index = history.insert(m, source);
    if (index < 0) {
      late++;
      return Outcome.TOO_LATE;
    }
    boolean isNewest = index == history.count() - 1;
    if (!isNewest) {
      replayed++;
      now.copyFrom(history.before(index));
    }
    for (int i = index; i < history.count(); i++) {
      History.Entry entry = history.at(i);
      fuser.fuse(now, entry.measurement, entry.source);
      entry.after.copyFrom(now);
    }
    return isNewest ? Outcome.FUSED : Outcome.REPLAYED;
  }

  /** The estimate, carried ahead to that time [µs] if it is later than the newest measurement. */
  public Estimate at(long micros) {
    ahead.copyFrom(now);
    process.predict(ahead, micros);
    return new Estimate(ahead, look, tuning);
  }

  /** Time of the newest measurement [µs]. */
  public long micros() {
    return now.micros;
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
    return now.resets;
  }

  /** What is known of the sources. */
  public SourceReports sources() {
    return new SourceReports(now, trust, tuning);
  }

  SourceTrust trust() {
    return trust;
  }

  FilterState state() {
    return now;
  }

  /** Goes on from another state, as after a restart. */
  void resume(FilterState from) {
    now.copyFrom(from);
    history.restart(now);
  }
}
