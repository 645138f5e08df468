package org.u2sa.estimation;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.estimation.fusion.EstimateWriter;
import org.u2sa.estimation.fusion.FilterMemory;
import org.u2sa.estimation.fusion.LocalOdometry;
import org.u2sa.estimation.fusion.Measurement;
import org.u2sa.estimation.fusion.MeasurementReader;
import org.u2sa.estimation.fusion.SourceReports.Report;
import org.u2sa.estimation.fusion.SourceReports.Standing;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;

/**
 * Fuses whatever proprioceptive sources there are into one state with honest standard deviations
 * (thesis 3.2.3.1, 5.1), by an {@link ErrorStateFilter}. A source is known by its messages alone
 * and registered at the first. In: sensed-state. Out: state, carried ahead to now; local-state, a
 * dead reckoning that never jumps.
 *
 * <p>What a sensor says beyond what every state has, such as whether weight is on the wheels, is
 * passed on.
 *
 * <p>Health remarks say of each source whether it is used, gated, biased, frozen or silent.
 */
public final class FusingStateEstimator extends StateEstimator {
  private static final String LOCAL = "LOCAL STATE";
  private static final String STATE = "STATE";
  private static final long REPORT_MICROS = 500_000L;
  private static final int REPORTS_REMEMBERED = 10;
  private static final int WARN_OF_LATE = 100;
  private static final double OWN_FIELDS_FRESH_S = 2.0;
  private static final String START = "start"; // of the source that the surveyed start is

  private final FusionVariables variables;
  private final ErrorStateFilter filter;
  private final MeasurementReader reader;
  private final LeverArms leverArms;
  private final Measurement measurement = new Measurement();
  private final LocalOdometry odometry = new LocalOdometry();
  private final Completeness completeness;
  private final Map<String, Standing> standings = new TreeMap<>();
  private final Map<String, StateInformation> newest = new TreeMap<>();
  private long publishedMicros = Long.MIN_VALUE;
  private long reportedMicros = Long.MIN_VALUE;
  private long reports;
  private long resets;
  private boolean isStartTold;
  private boolean isHeadingTold;

  /** Called by the launcher. */
  public FusingStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
    variables = settings(FusionVariables.class).get(); // another one counts from the next start
    filter = new ErrorStateFilter(variables.tuning());
    reader = new MeasurementReader(variables.sigmas());
    leverArms = new LeverArms(variables.leverArms());
    completeness =
        new Completeness(
            this,
            Completeness.fields(variables.needed()),
            Clock.micros(variables.completeWithin()));
    registerPublisher(Channels.LOCAL_STATE);
  }

  @Override
  protected Optional<StateInformation> estimate(StateInformation sensed) {
    long now = clock().micros();
    long micros = sensed.timestamp().orElseThrow();
    if (isFromTheFuture(sensed)) {
      return Optional.empty();
    }
    try {
      reader.read(sensed, measurement);
    } catch (IllegalArgumentException e) {
      ignore(sensed, e.getMessage());
      return Optional.empty();
    }
    newest.put(sensed.sensorName(), sensed);
    if (filter.add(leverArms.place(measurement)) == ErrorStateFilter.Outcome.TOO_LATE) {
      if (filter.late() % WARN_OF_LATE == 1) {
        log(LogLevelEnum.WARN, sensed.sensorName() + " is later than HORIZON: " + filter.late());
      }
      return Optional.empty();
    }
    tellStart();
    report(Math.max(now, filter.micros()));
    long at = Math.max(now, filter.micros());
    boolean isDue = at - publishedMicros >= Clock.micros(1.0 / variables.outputRate());
    return publishedMicros == Long.MIN_VALUE || isDue ? Optional.of(state(at)) : Optional.empty();
  }

  /**
   * The heading in which it was put, and the place, as soon as a receiver says where it is about.
   */
  private void tellStart() {
    if (!isHeadingTold && variables.startPsiSigma() > 0.0) {
      isHeadingTold = true;
      double sigma = Math.toRadians(variables.startPsiSigma());
      measurement.begin(START, filter.micros());
      filter.add(measurement.heading(Math.toRadians(variables.startPsi()), sigma));
    }
    if (!isStartTold && variables.startSigma() > 0.0 && filter.at(filter.micros()).isOnEarth()) {
      isStartTold = true;
      double sigma = variables.startSigma();
      measurement.begin(START, filter.micros());
      filter.add(measurement.place(variables.startY(), variables.startX(), sigma, sigma));
    }
  }

  private StateInformation state(long micros) {
    publishedMicros = micros;
    Estimate estimate = filter.at(micros);
    odometry.moveTo(estimate);
    if (estimate.hasHeading()) {
      StateInformation local = odometry.write(estimate);
      publish(Channels.LOCAL_STATE, local.sensorName(getServiceName()));
    }
    StateInformation state = EstimateWriter.write(estimate);
    completeness.look(state, newest.values());
    return OwnFields.with(state, saysMore(micros));
  }

  /** The newest sensor that says more than any state has, unless it fell silent. */
  private List<StateInformation> saysMore(long now) {
    return newest.values().stream()
        .filter(OwnFields::isRicher)
        .filter(each -> now - micros(each) <= Clock.micros(OWN_FIELDS_FRESH_S))
        .max(Comparator.comparingLong(FusingStateEstimator::micros))
        .map(List::of)
        .orElse(List.of());
  }

  private static long micros(StateInformation sensed) {
    return sensed.timestamp().orElseThrow();
  }

  private void report(long now) {
    if (reportedMicros != Long.MIN_VALUE && now - reportedMicros < REPORT_MICROS) {
      return;
    }
    reportedMicros = now;
    if (++reports % REPORTS_REMEMBERED == 0) {
      remember();
    }
    for (Report report : filter.sources().at(now)) {
      if (report.source().equals(START) && report.standing() == Standing.SILENT) {
        continue; // it has said what it had to
      }
      remark(report.source(), report.text());
      Standing before = standings.put(report.source(), report.standing());
      if (before != report.standing()) {
        say(report, before);
      }
    }
    remark(
        "all sources",
        "late "
            + filter.late()
            + ", replayed "
            + filter.replayed()
            + ", begun anew "
            + filter.resets());
    if (filter.resets() > resets) {
      trouble("all sources of a quantity contradicted the estimate: it began anew from them");
    }
    resets = filter.resets();
  }

  private void say(Report report, Standing before) {
    boolean isFine = report.standing() == Standing.USED || report.standing() == Standing.UNUSED;
    if (!isFine) {
      trouble(report.source() + " " + report.text());
    } else if (before != Standing.UNUSED || report.standing() == Standing.USED) {
      log(report.source() + " " + report.text());
    }
  }

  @Override
  protected void handOver(HandOver state) {
    state.messages("MEASUREMENTS", newest.values());
    FilterMemory.write(filter, state::text);
    if (publishedMicros != Long.MIN_VALUE) {
      Estimate estimate = filter.at(publishedMicros);
      state.message(STATE, EstimateWriter.write(estimate).sensorName(getServiceName()));
      if (estimate.hasHeading()) {
        state.message(LOCAL, odometry.write(estimate));
      }
    }
  }

  @Override
  protected void takeOver(HandOver state) {
    state.message(LOCAL, StateInformation.class).ifPresent(odometry::resume);
    isStartTold = true; // it has left there
    isHeadingTold = true;
    if (!FilterMemory.read(filter, state::text)) {
      for (StateInformation each : state.messages("MEASUREMENTS", StateInformation.class)) {
        filter.add(
            leverArms.place(
                reader.read(each, measurement))); // of another estimator: a start at least
      }
    }
  }
}
