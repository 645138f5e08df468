package org.u2sa.cli.run;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Prints why a vehicle stops or leaves its mission: emergency stops, failsafe actions, disarming.
 * Each event is one line; repetitions and changes of numbers in a cause are not printed.
 */
public final class SafetyLines implements Receiver, AutoCloseable {
  private static final int MAX_TEXT = 300;
  private static final int MAX_EVENTS = 100;

  private final Clock clock;
  private final double armedWithinS;
  private final Consumer<String> console;
  private final long beganMicros;
  private final Connection connection;
  private final Set<String> stops = new HashSet<>(); // in force; this and the rest guarded by this
  private final List<String> interventions = new ArrayList<>();
  private boolean wasArmed; // at any time
  private boolean armed;
  private String objections = ""; // printed reasons not to arm
  private String failsafe = ""; // printed action with the number of its causes

  /**
   * @param transport to the system's messages
   * @param clock of the run
   * @param armedWithinS time after which a vehicle that was never armed is reported, with the
   *     reasons [s]; infinite for never
   * @param console receives the lines
   */
  public SafetyLines(
      Transport transport, Clock clock, double armedWithinS, Consumer<String> console) {
    this.clock = clock;
    this.armedWithinS = armedWithinS;
    this.console = console;
    beganMicros = clock.micros();
    connection = transport.connect("u2sa-run-safety", this);
    connection.subscribe(Channels.EMERGENCY_STOP);
    connection.subscribe(Channels.FAILSAFE);
    connection.subscribe(Channels.ARMING_STATE);
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof EmergencyStop stop) {
      take(stop);
    } else if (message instanceof FailsafeState state) {
      take(state);
    } else if (message instanceof ArmingState state) {
      take(state);
    }
  }

  private void take(EmergencyStop stop) {
    if (!stop.active()) {
      if (!stops.isEmpty()) {
        stops.clear();
        print("emergency stop cleared by \"" + stop.operator() + "\"");
      }
      return;
    }
    String line = "emergency stop by \"" + stop.operator() + "\": " + stop.reason();
    if (stops.size() < MAX_EVENTS && stops.add(line)) {
      intervene(line);
    }
  }

  /** An emergency stop, which has its own line, is also published as the action STOP. */
  private void take(FailsafeState state) {
    FailsafeAction action = state.action();
    boolean acts = action != FailsafeAction.CONTINUE && action != FailsafeAction.STOP;
    String gist = acts ? action + " " + state.causes().size() : "";
    if (gist.equals(failsafe)) {
      return;
    }
    if (acts) {
      intervene("failsafe " + action + " because of " + String.join("; ", state.causes()));
    } else if (action == FailsafeAction.CONTINUE) {
      print("failsafe ended");
    }
    failsafe = gist;
  }

  private void take(ArmingState state) {
    if (state.armed()) {
      if (wasArmed && !armed) {
        print("armed again");
      }
      wasArmed = true;
    } else if (armed) {
      print("disarmed");
    } else if (!wasArmed && Clock.seconds(clock.micros() - beganMicros) > armedWithinS) {
      tellObjections(state.reasons());
    }
    armed = state.armed();
  }

  private void tellObjections(List<String> reasons) {
    String line = "not armed: " + String.join("; ", reasons);
    String gist = line.replaceAll("[0-9.]+", "");
    if (!reasons.isEmpty() && !gist.equals(objections)) {
      objections = gist;
      print(line);
    }
  }

  private void intervene(String line) {
    if (interventions.size() < MAX_EVENTS) {
      interventions.add(print(line));
    }
  }

  private String print(String line) {
    String cut = line.length() > MAX_TEXT ? line.substring(0, MAX_TEXT) + "…" : line;
    String plain = OneLine.of(cut);
    console.accept(plain);
    return plain;
  }

  /** The emergency stops and failsafe actions so far, as printed. */
  public synchronized List<String> interventions() {
    return List.copyOf(interventions);
  }

  /** {@inheritDoc} Reported by {@link TroubleLines}. */
  @Override
  public void trouble(String what) {}

  @Override
  public void close() {
    connection.close();
  }
}
