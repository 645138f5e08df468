package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.ServiceKit;

/**
 * Whatever stops, clears, repetitions, late starters and swaps come in whatever order: no actuator
 * moves while a stop stands.
 */
class EmergencyStopProperties {
  /** What happens next: a kind, and which of the stops so far it concerns. */
  record Event(Kind kind, int which) {}

  enum Kind {
    STOP,
    STOP_WITHOUT_ID,
    CLEAR_BY_NAME,
    CLEAR_BY_TIME,
    CLEAR_OF_ANOTHER_SYSTEM,
    CLEAR_OF_NOTHING,
    REPEAT,
    LATECOMER,
    SWAP
  }

  @Provide
  Arbitrary<List<Event>> events() {
    Arbitrary<Kind> kinds = Arbitraries.of(Kind.class);
    Arbitrary<Integer> which = Arbitraries.integers().between(0, 9);
    return Combinators.combine(kinds, which).as(Event::new).list().ofMinSize(1).ofMaxSize(25);
  }

  /** Moves if it is told to and may. */
  private static final class Motor extends Actuator {
    private double percent;

    Motor(ServiceContext context) {
      super(context, "Motor");
    }

    @Override
    protected void actuate(double percentage) {
      percent = percentage;
    }

    @Override
    protected void neutral() {
      percent = 0.0;
    }
  }

  /** A vehicle, and what must be true of it by the rules of docs/health-and-failsafes.md. */
  private static final class Boat implements AutoCloseable {
    private final ServiceKit kit = new ServiceKit();
    private final List<Motor> motors = new ArrayList<>();
    private final List<EmergencyStop> said = new ArrayList<>();
    private final Set<EmergencyStop> standing = new LinkedHashSet<>();

    Boat() {
      add();
    }

    void add() {
      kit.withoutVariables().with("SERVICE NAME", "Motor" + motors.size());
      motors.add(kit.start(Motor::new));
    }

    void happen(Event event) {
      switch (event.kind()) {
        case STOP -> stop(new EmergencyStop().active(true).stopId("stop " + said.size()));
        case STOP_WITHOUT_ID -> stop(new EmergencyStop().active(true).operator("" + said.size()));
        case LATECOMER -> add();
        case SWAP -> {
          int last = motors.size() - 1;
          motors.set(last, kit.swap(motors.get(last), Motor::new));
        }
        default -> happenTo(event.kind(), pick(event.which()));
      }
    }

    private EmergencyStop pick(int which) {
      return said.isEmpty() ? null : said.get(which % said.size());
    }

    private void stop(EmergencyStop stop) {
      kit.publish(Channels.EMERGENCY_STOP, stop);
      said.add(stop);
      standing.add(stop);
    }

    private void happenTo(Kind kind, EmergencyStop stop) {
      if (stop == null) {
        return;
      }
      EmergencyStop clear = new EmergencyStop().active(false);
      switch (kind) {
        case REPEAT -> {
          kit.publish(Channels.EMERGENCY_STOP, (EmergencyStop) stop.copy());
          return;
        }
        case CLEAR_BY_NAME -> {
          clear.lifts(List.of(stop.identity()));
          lift(Set.of(stop));
        }
        case CLEAR_BY_TIME -> {
          clear.clears(stop.timestamp().orElseThrow());
          Set<EmergencyStop> upTo = new LinkedHashSet<>(said);
          upTo.removeIf(each -> each.timestamp().orElseThrow() > stop.timestamp().orElseThrow());
          lift(upTo);
        }
        case CLEAR_OF_ANOTHER_SYSTEM -> clear.clears(Long.MAX_VALUE).systemId("another");
        default -> clear.lifts(List.of("no such stop"));
      }
      kit.publish(Channels.EMERGENCY_STOP, clear);
    }

    private void lift(Set<EmergencyStop> stops) {
      standing.removeAll(stops);
    }

    /** Commands all, and looks who moves. */
    void requireRight() {
      for (Motor motor : motors) {
        kit.publish(Channels.ACTUATION, PercentageCommand.of(motor.actuatorName(), 50.0));
        if (standing.isEmpty()) {
          continue; // one that came late may know of a stop that was lifted before: the safe side
        }
        assertThat(motor.percent).as("%s while %s stand", motor.getName(), standing).isZero();
      }
    }

    @Override
    public void close() {
      kit.close();
    }
  }

  @Property(tries = 150)
  void anySequence_whileAStopStands_nothingMoves(@ForAll("events") List<Event> events) {
    try (Boat boat = new Boat()) {
      for (Event event : events) {
        boat.happen(event);
        boat.kit.advance(0.05);
        boat.requireRight();
      }
    }
  }

  @Property(tries = 50)
  void anySequence_thenEveryStopCleared_itMovesAgain(@ForAll("events") List<Event> events) {
    try (Boat boat = new Boat()) {
      events.forEach(boat::happen);
      List<String> all = boat.said.stream().map(EmergencyStop::identity).toList();
      boat.kit.publish(
          Channels.EMERGENCY_STOP,
          new EmergencyStop().active(false).lifts(all).clears(Long.MAX_VALUE));

      for (Motor motor : boat.motors) {
        boat.kit.publish(Channels.ACTUATION, PercentageCommand.of(motor.actuatorName(), 50.0));
        assertThat(motor.percent).as("%s after all were cleared", motor.getName()).isEqualTo(50.0);
      }
    }
  }
}
