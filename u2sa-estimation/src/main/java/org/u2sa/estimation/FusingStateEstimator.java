package org.u2sa.estimation;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.estimation.fusion.FilterMemory;
import org.u2sa.estimation.fusion.MotionDomain;
import org.u2sa.estimation.fusion.SourceReports.Report;
import org.u2sa.estimation.fusion.SourceReports.Standing;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.MeasurementReader;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Fuses all available proprioceptive sources into one state with consistent standard deviations
 * (thesis 3.2.3.1, 5.1), using an {@link ErrorStateFilter}. Sources are known only by their
 * messages and registered on the first one. In: sensed-state. Out: state, predicted to the current
 * time; local-state, a dead-reckoned pose that never jumps.
 *
 * <p>Sensor fields beyond the common state fields, such as weight on wheels, are passed on.
 *
 * <p>Health remarks report for each source whether it is used, gated, biased, frozen or silent.
 */
public final class FusingStateEstimator extends StateEstimator {
  private static final String LOCAL = "LOCAL STATE";
  private static final String STATE = "STATE";
  private static final double NOTEWORTHY_DELAY_S = 0.1;
  private static final long REPORT_MICROS = 500_000L;
  private static final int REPORTS_REMEMBERED = 10;
  private static final int WARN_OF_LATE = 100;
  private static final double OWN_FIELDS_FRESH_S = 2.0;
  private static final int UNHEARD_AFTER_REPORTS = 20;
  private static final String UNHEARD =
      "sensors in LEVER ARMS, FLUID SENSORS or WIND SENSORS that have not reported";
  private static final String START = "start"; // source name of the surveyed start

  private final FusionVariables variables;
  private final ErrorStateFilter filter;
  private final MeasurementReader reader;
  private final LeverArms leverArms;
  private final Optional<SailDrift> sailDrift;
  private final Optional<AirspeedWatch> airspeeds; // for aircraft only
  private final Measurement measurement = new Measurement();
  private final LocalOdometry odometry = new LocalOdometry();
  private final Completeness completeness;
  private final Set<String> late = new TreeSet<>(); // sources that were logged as late
  private final Map<String, Standing> standings = new TreeMap<>();
  private final Map<String, StateInformation> newest = new TreeMap<>();
  private final InertialPace pace = new InertialPace();
  private long publishedMicros = Long.MIN_VALUE;
  private long reportedMicros = Long.MIN_VALUE;
  private long reports;
  private long resets;
  private boolean isStartTold;
  private boolean isHeadingTold;

  public FusingStateEstimator(ServiceContext context) {
    super(context, "StateEstimator");
    variables = settings(FusionVariables.class).get(); // changes take effect at the next start
    filter = new ErrorStateFilter(variables.tuning());
    reader = new MeasurementReader(variables.sigmas(), variables.fluid());
    leverArms = new LeverArms(variables.leverArms());
    sailDrift = variables.sailDrift();
    airspeeds =
        variables.tuning().domain() == MotionDomain.AIR
            ? Optional.of(new AirspeedWatch(this::trouble))
            : Optional.empty();
    completeness = NeededNumbers.watch(this);
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
      reader.read(checked(sensed), measurement);
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
    pace.hear(measurement, at);
    double periodS = 1.0 / variables.outputRate();
    boolean isDue =
        publishedMicros == Long.MIN_VALUE
            || at - publishedMicros >= Clock.micros(periodS)
                && !pace.isNextDue(filter, at, periodS);
    return isDue ? Optional.of(state(at)) : Optional.empty();
  }

  private StateInformation checked(StateInformation sensed) {
    return sailDrift
        .map(drift -> drift.throughWater(sensed))
        .or(() -> airspeeds.map(watch -> watch.checked(sensed)))
        .orElse(sensed);
  }

  /**
   * Feeds the surveyed start heading and, once a receiver agrees or if there is none, the surveyed
   * position.
   */
  private void tellStart() {
    if (!isHeadingTold && variables.startPsiSigma() > 0.0) {
      isHeadingTold = true;
      double sigma = Math.toRadians(variables.startPsiSigma());
      measurement.begin(START, filter.micros());
      filter.add(measurement.heading(Math.toRadians(variables.startPsi()), sigma));
    }
    if (!isStartTold
        && variables.startSigma() > 0.0
        && (variables.startWithoutReceiver() || filter.at(filter.micros()).isOnEarth())) {
      isStartTold = true;
      double sigma = variables.startSigma();
      measurement.begin(START, filter.micros());
      filter.add(measurement.place(variables.startY(), variables.startX(), sigma, sigma));
    }
  }

  /** Starts at the position of another estimator, which no receiver may measure at present. */
  private void beginAt(StateInformation state) {
    if (state.referenceFrame().equals(ReferenceFrame.GLOBAL)
        && state.x().isPresent()
        && state.y().isPresent()) {
      double east = state.xSigma().orElse(variables.sigmas().position());
      double north = state.ySigma().orElse(variables.sigmas().position());
      measurement.begin(START, micros(state));
      filter.add(measurement.place(state.y().getAsDouble(), state.x().getAsDouble(), north, east));
    }
  }

  private StateInformation state(long micros) {
    publishedMicros = micros;
    Estimate estimate = filter.at(micros);
    odometry.moveTo(estimate);
    airspeeds.ifPresent(watch -> watch.see(estimate));
    if (estimate.hasHeading()) {
      StateInformation local = odometry.write(estimate);
      publish(Channels.LOCAL_STATE, local.sensorName(getServiceName()));
    }
    StateInformation state = EstimateWriter.write(estimate);
    completeness.look(state, newest.values());
    return OwnFields.with(state, saysMore(micros));
  }

  /** Newest measurement with additional fields, unless that sensor has gone silent. */
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
        continue; // a one-time source falls silent as expected
      }
      remark(report.source(), report.text());
      Standing before = standings.put(report.source(), report.standing());
      if (before != report.standing()) {
        say(report, before);
      }
      if (report.lateS() >= NOTEWORTHY_DELAY_S && late.add(report.source())) {
        log(report.source() + " is late by more than declared: " + report.text());
      }
    }
    remarkUnheard();
    remark(
        "all sources",
        "late " + filter.late() + ", replayed " + filter.replayed() + ", reset " + filter.resets());
    if (filter.resets() > resets) {
      trouble("all sources of a quantity contradicted the estimate: it was reset to them");
    }
    resets = filter.resets();
  }

  /** Names sensors in variables that have not reported: a misspelt one would have no effect. */
  private void remarkUnheard() {
    Set<String> unheard = variables.sensors();
    unheard.removeAll(newest.keySet());
    newest.keySet().forEach(source -> unheard.remove(SensorParts.sensor(source)));
    if (reports < UNHEARD_AFTER_REPORTS || unheard.isEmpty()) {
      remark(UNHEARD, "");
      return;
    }
    String what =
        String.join(", ", unheard) + "; these have: " + String.join(", ", newest.keySet());
    remark(UNHEARD, what);
    if (reports == UNHEARD_AFTER_REPORTS) {
      trouble(UNHEARD + ": " + what);
    }
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
    airspeeds.ifPresent(watch -> watch.handOver(state));
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
    isStartTold = true; // the vehicle has left the start
    isHeadingTold = true;
    airspeeds.ifPresent(watch -> watch.takeOver(state));
    if (!FilterMemory.read(filter, state::text)) {
      state.message(STATE, StateInformation.class).ifPresent(this::beginAt);
      for (StateInformation each : state.messages("MEASUREMENTS", StateInformation.class)) {
        filter.add(leverArms.place(reader.read(each, measurement))); // gives a start, at least
      }
    }
  }
}
