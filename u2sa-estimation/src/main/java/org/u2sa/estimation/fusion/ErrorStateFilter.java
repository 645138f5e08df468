package org.u2sa.estimation.fusion;

import java.util.Optional;
import org.u2sa.estimation.measurement.Measurement;

/**
 * Error-state extended Kalman filter (Solà 2017, arXiv 1711.02508) that accepts any sources,
 * identified by name from their first measurement on. Measurements may arrive late and out of
 * order: they are inserted at their time, and all later ones are fused again, lazily at the next
 * query, so that several late arrivals cost only one replay.
 *
 * <p>Not thread-safe. Does not allocate once all sources are known.
 */
public final class ErrorStateFilter {
  private static final double LONGEST_GAP_S = 600.0;

  /** Result of adding a measurement. */
  public enum Outcome {
    /** It is the newest measurement. */
    FUSED,
    /** It was late, and was inserted at its time. */
    REPLAYED,
    /** It was older than the horizon and was discarded. */
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

  /** Creates an uninitialised filter. */
  public ErrorStateFilter(FilterTuning tuning) {
    this.tuning = tuning;
    trust = new SourceTrust(tuning.window());
    process = new ProcessModel(tuning);
    fuser = new Fuser(tuning, trust, process);
    history = new History(tuning.history());
    horizonMicros = (long) Math.ceil(tuning.horizonS() * 1e6);
  }

  /** Adds a copy of a measurement. */
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
      fuse(); // the oldest entry survives only in the state after it
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

  /** Estimate at the newest measurement, predicted to the given time [µs] if that is later. */
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

  /** Number of measurements discarded as older than the horizon. */
  public long late() {
    return late;
  }

  /** Number of late measurements that were fused at their time. */
  public long replayed() {
    return replayed;
  }

  /** Number of resets of a quantity that all its sources contradicted. */
  public long resets() {
    return state().resets;
  }

  /** Source whose angular rates drive the prediction; empty if none does. */
  public Optional<String> inertialSource() {
    FilterState state = state();
    return state.isInertial && state.gyroSource >= 0
        ? Optional.of(trust.name(state.gyroSource))
        : Optional.empty();
  }

  /** Mean time between its samples [s]. */
  public double inertialIntervalS() {
    return state().x[FilterState.INPUT_INTERVAL];
  }

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

  /** Resumes from another state, e.g. after a restart. */
  void resume(FilterState from) {
    history.restart(from);
  }
}
