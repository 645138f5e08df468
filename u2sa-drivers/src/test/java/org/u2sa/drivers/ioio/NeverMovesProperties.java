package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalLong;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.ioio.PulseTrain;

/**
 * Whatever happens in whatever order, the pins give no pulse but neutral while the vehicle must not
 * move: from the moment of an emergency stop or a disarming, and from the time that the radio's
 * switch and missing commands take to be seen.
 */
class NeverMovesProperties {
  private static final double SPAN_S = 0.05;
  private static final double RADIO_S = 0.30; // time-out of the radio, a pulse and a step
  private static final double EXPIRY_S = 0.52; // of commands, and a step

  /** What may happen; each is followed by a span of time in which control commands or not. */
  enum Event {
    NOTHING,
    NOTHING_MORE,
    STOP,
    CLEAR,
    ARM,
    DISARM,
    MANUAL,
    RECEIVER_OFF,
    AUTOMATIC,
    POWER_OFF,
    POWER_ON,
    CONTROL_HANGS,
    CONTROL_WORKS,
    GARBAGE_TO_THE_BOARD
  }

  /** The state of one drive. */
  private static final class Drive implements AutoCloseable {
    private final BoardKit on = new BoardKit();
    private OptionalLong stop = OptionalLong.empty(); // its time, while one holds
    private boolean armed = true;
    private boolean automatic = true;
    private boolean controlWorks = true;
    private double manualSinceS;
    private double silentSinceS;
    private double movedS;

    Drive() {
      on.kit.with("REQUIRES ARMING", true);
      on.start();
      on.kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    }

    void happen(Event event) throws Exception {
      switch (event) {
        case STOP -> stop();
        case CLEAR -> clear();
        case ARM, DISARM -> arm(event == Event.ARM);
        case MANUAL -> radio(1.1e-3);
        case RECEIVER_OFF -> radio(0.0);
        case AUTOMATIC -> radio(1.9e-3);
        case POWER_OFF -> on.board.power(false);
        case POWER_ON -> on.board.power(true);
        case CONTROL_HANGS, CONTROL_WORKS -> control(event == Event.CONTROL_WORKS);
        case GARBAGE_TO_THE_BOARD -> garbage();
        default -> {}
      }
      boolean mustRest = mustRest(on.kit.nowS());
      int leftFrom = on.bench.history(BoardKit.LEFT, 0).size();
      int rightFrom = on.bench.history(BoardKit.RIGHT, 0).size();
      if (mustRest) {
        expectRest(event, List.of(pulse(BoardKit.LEFT), pulse(BoardKit.RIGHT)));
      }
      if (controlWorks) {
        on.command("LEFT MOTOR", 100.0);
        on.command("RIGHT MOTOR", -100.0);
      }
      on.kit.advance(SPAN_S);
      movedS += Math.abs(on.bench.width(BoardKit.LEFT) - BoardKit.NEUTRAL_S) > 2e-4 ? SPAN_S : 0.0;
      if (mustRest) {
        expectRest(event, on.bench.history(BoardKit.LEFT, leftFrom));
        expectRest(event, on.bench.history(BoardKit.RIGHT, rightFrom));
      }
    }

    private PulseTrain pulse(int pin) {
      double widthS = on.bench.width(pin);
      return new PulseTrain(widthS, Math.max(widthS, 0.02));
    }

    private boolean mustRest(double nowS) {
      return stop.isPresent()
          || !armed
          || !automatic && nowS - manualSinceS > RADIO_S
          || !controlWorks && nowS - silentSinceS > EXPIRY_S;
    }

    private static void expectRest(Event event, List<PulseTrain> pulses) {
      assertThat(pulses)
          .as("pulses after %s", event)
          .allMatch(
              train ->
                  train.widthS() == 0.0
                      || Math.abs(train.widthS() - BoardKit.NEUTRAL_S) < BoardKit.RESOLUTION_S);
    }

    private void stop() {
      EmergencyStop message = new EmergencyStop().active(true).operator("test");
      on.kit.publish(Channels.EMERGENCY_STOP, message);
      stop = message.timestamp();
    }

    private void clear() {
      if (stop.isPresent()) {
        EmergencyStop lifted = new EmergencyStop().active(false).operator("test");
        on.kit.publish(Channels.EMERGENCY_STOP, lifted.clears(stop.getAsLong()));
        stop = OptionalLong.empty();
      }
    }

    private void arm(boolean newArmed) {
      armed = newArmed;
      ArmingState state = new ArmingState().armed(armed).reasons(List.of("test"));
      on.kit.publish(Channels.ARMING_STATE, state);
    }

    private void radio(double widthS) {
      boolean wasAutomatic = automatic;
      automatic = widthS > 1.8e-3;
      manualSinceS = wasAutomatic && !automatic ? on.kit.nowS() : manualSinceS;
      on.bench.pulses(35, widthS);
    }

    private void control(boolean works) {
      silentSinceS = controlWorks && !works ? on.kit.nowS() : silentSinceS;
      controlWorks = works;
    }

    private void garbage() throws Exception {
      if (on.bench.firmware.isOpen()) {
        on.board.output().write(0xFF);
      }
    }

    @Override
    public void close() {
      on.close();
    }
  }

  @Property(tries = 25)
  void pulses_anyEvents_areNeutralWhileItMustNotMove(@ForAll @Size(max = 40) List<Event> events)
      throws Exception {
    try (Drive drive = new Drive()) {
      for (Event event : events) {
        drive.happen(event);
      }
    }
  }

  /** That the property above watches something that moves. */
  @Property(tries = 1)
  void pulses_nothingHappens_vehicleMoves() throws Exception {
    try (Drive drive = new Drive()) {
      for (int i = 0; i < 20; i++) {
        drive.happen(Event.NOTHING);
      }
      assertThat(drive.movedS).isGreaterThan(0.5);
    }
  }
}
