package org.u2sa.core.safety;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.MessageAge;

/** Checks the position: lost when states are stale, lack x and y, or are too uncertain. */
final class PositionWatch implements Watch {
  private static final String NEWEST = "state";
  private static final String AGE = "state heard before";

  private final Supplier<SafetyVariables> settings;
  private StateInformation newest; // null until the first
  private long heardMicros; // arrival of the newest

  PositionWatch(Supplier<SafetyVariables> settings) {
    this.settings = settings;
  }

  @Override
  public Hazard hazard() {
    return Hazard.POSITION;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof StateInformation state && state.timestamp().isPresent()) {
      newest = state;
      heardMicros = nowMicros;
    }
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    if (newest != null) {
      state.message(NEWEST, newest).number(AGE, Clock.seconds(nowMicros - heardMicros));
    }
  }

  /** After a restart the vehicle may be elsewhere: only states that arrive after it count. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    if (upToDate) {
      newest = state.message(NEWEST, StateInformation.class).orElse(null);
      heardMicros = nowMicros - Clock.micros(state.number(AGE).orElse(0.0));
    }
  }

  /** The newest state, unless it is older than its deadline. */
  Optional<StateInformation> fresh(long nowMicros) {
    return newest != null && ageS(nowMicros) <= settings.get().stateDeadline()
        ? Optional.of(newest)
        : Optional.empty();
  }

  private double ageS(long nowMicros) {
    return Clock.seconds(MessageAge.micros(newest, heardMicros, nowMicros));
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    if (newest == null) {
      return Optional.of("no state yet");
    }
    if (fresh(nowMicros).isEmpty()) {
      return Optional.of("state is " + CauseText.seconds(ageS(nowMicros)) + " old");
    }
    if (newest.x().isEmpty() || newest.y().isEmpty()) {
      return Optional.of("state lacks x or y");
    }
    double sigmaM = Math.max(newest.xSigma().orElse(0.0), newest.ySigma().orElse(0.0));
    double limitM = settings.get().positionSigmaLimit();
    return sigmaM > limitM
        ? Optional.of(
            "uncertain by " + CauseText.metres(sigmaM) + ", limit " + CauseText.metres(limitM))
        : Optional.empty();
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return settings.get().positionRequired() ? trouble(nowMicros) : Optional.empty();
  }
}
