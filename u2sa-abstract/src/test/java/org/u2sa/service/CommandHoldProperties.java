package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.Tuple.Tuple3;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.actuator.CommandHold;
import org.u2sa.service.actuator.CommandRefusal;

/** Whatever comes, in whatever order: an actuator moves by a valid command in time, or not. */
class CommandHoldProperties {
  private static final double LEAST = -20.0;
  private static final double MOST = 80.0;
  private static final double EXPIRY_S = 0.5;
  private static final double TOLERANCE_S = 1.0;
  private static final double NONE = -1.0; // the command gives no expiry

  /** A command as it arrives, and the time that passes afterwards. */
  private record Arrival(
      double percentage,
      String system,
      String actuator,
      double aheadS,
      double expiryS,
      double thenS) {
    PercentageCommand command(long nowMicros) {
      PercentageCommand command = new AnyNumber(actuator, percentage);
      command.systemId(system);
      command.timestamp(nowMicros + Clock.micros(aheadS));
      return expiryS == NONE ? command : command.expiry(expiryS);
    }

    boolean isInRange() {
      return percentage >= LEAST && percentage <= MOST; // false for NaN
    }

    double holdsS() {
      return (expiryS == NONE ? EXPIRY_S : expiryS) + Math.min(0.0, aheadS);
    }

    boolean isValid() {
      return isInRange()
          && actuator.equals("RUDDER")
          && !system.equals("other")
          && aheadS <= TOLERANCE_S
          && Clock.micros(holdsS()) > 0;
    }
  }

  /** A subclass that says what no field of a message can hold. */
  private static final class AnyNumber extends PercentageCommand {
    private final double percentage;

    AnyNumber(String actuator, double percentage) {
      this.percentage = percentage;
      actuatorName(actuator).percentage(0.0);
    }

    @Override
    public double percentage() {
      return percentage;
    }
  }

  @Provide
  static Arbitrary<List<Arrival>> arrivals() {
    Arbitrary<Double> percentages =
        Arbitraries.frequencyOf(
            Tuple.of(6, Arbitraries.doubles().between(LEAST, MOST)),
            Tuple.of(2, Arbitraries.doubles().between(-150.0, 150.0)),
            Tuple.of(
                1,
                Arbitraries.of(
                    Double.NaN,
                    Double.POSITIVE_INFINITY,
                    Double.NEGATIVE_INFINITY,
                    -0.0,
                    Double.MIN_VALUE,
                    Math.nextUp(MOST),
                    Math.nextDown(LEAST))));
    Arbitrary<Tuple3<String, String, Double>> origins =
        Combinators.combine(
                Arbitraries.of("boat", "boat", "boat", "", "other"),
                Arbitraries.of("RUDDER", "RUDDER", "RUDDER", "SAIL"),
                Arbitraries.doubles().between(-1.5, 1.5))
            .as(Tuple::of);
    Arbitrary<Double> expiries =
        Arbitraries.oneOf(
            Arbitraries.just(NONE),
            Arbitraries.doubles().between(0.001, 2.0).ofScale(3),
            Arbitraries.just(1e15));
    return Combinators.combine(
            percentages, origins, expiries, Arbitraries.doubles().between(0.0, 1.0).ofScale(3))
        .as(CommandHoldProperties::arrival)
        .list()
        .ofMaxSize(30);
  }

  private static Arrival arrival(
      double percentage, Tuple3<String, String, Double> origin, double expiryS, double thenS) {
    return new Arrival(percentage, origin.get1(), origin.get2(), origin.get3(), expiryS, thenS);
  }

  @Property(tries = 1000)
  void percentage_afterAnyCommands_isOfTheNewestValidOneInTimeOrNone(
      @ForAll("arrivals") List<Arrival> arrivals) throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    clock.advance(Clock.micros(10.0));
    CommandHold hold =
        new CommandHold(
            clock, "boat", EXPIRY_S, TOLERANCE_S, Map.of("RUDDER", Range.of(-100.0, 100.0)));
    hold.limit(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(LEAST).maximum(MOST));
    OptionalDouble held = OptionalDouble.empty();
    double untilS = 0.0;
    for (Arrival arrival : arrivals) {
      double nowS = Clock.seconds(clock.micros());
      Optional<CommandRefusal> refusal = hold.accept(arrival.command(clock.micros()));

      assertThat(refusal.isEmpty()).as("%s is taken", arrival).isEqualTo(arrival.isValid());
      if (arrival.isValid()) {
        held = OptionalDouble.of(arrival.percentage());
        untilS = nowS + arrival.holdsS();
      }
      clock.advance(Clock.micros(arrival.thenS()));
      double thenS = Clock.seconds(clock.micros());
      if (Math.abs(thenS - untilS) > 1e-5) { // times are rounded to microseconds
        assertThat(hold.percentage("RUDDER"))
            .as("after %s", arrival)
            .isEqualTo(thenS < untilS ? held : OptionalDouble.empty());
      }
    }
    assertThat(hold.percentage("SAIL")).isEmpty();
  }
}
