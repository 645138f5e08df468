package org.u2sa.scenarios.cessna;

import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.safety.FailsafeAction;

/** What goes wrong in a flight, one for each row of the failsafe matrix that a flight can show. */
enum Trouble {
  /** The operator's heartbeat stops. */
  OPERATOR("ON OPERATOR LOSS", "operator link") {
    @Override
    void begin(TroubledFlight flight) throws InterruptedException {
      flight.witness().operatorIsThere(true);
      flight.fly(2.0);
      flight.witness().operatorIsThere(false);
    }

    @Override
    void end(TroubledFlight flight) {
      flight.witness().operatorIsThere(true);
    }
  },
  /** The estimate becomes uncertain. */
  UNCERTAIN_POSITION("ON POSITION LOSS", "position") {
    @Override
    void begin(TroubledFlight flight) {
      flight.swapEstimator(TroubledEstimators.Uncertain.class);
    }

    @Override
    void end(TroubledFlight flight) {
      flight.repairEstimator();
    }
  },
  /** The estimator no longer knows where it is. */
  NO_POSITION("ON POSITION LOSS", "position") {
    @Override
    void begin(TroubledFlight flight) {
      flight.swapEstimator(TroubledEstimators.Lost.class);
    }

    @Override
    void end(TroubledFlight flight) {
      flight.repairEstimator();
    }
  },
  /** The estimates stop. */
  ESTIMATOR("ON ESTIMATOR LOSS", "state estimator") {
    @Override
    LaunchOptions configure(LaunchOptions options, FailsafeAction action) {
      return super.configure(options, action) // without estimates there is no position either
          .override("SafetyManager", "ON POSITION LOSS", action.name());
    }

    @Override
    void begin(TroubledFlight flight) {
      flight.swapEstimator(TroubledEstimators.Silent.class);
    }

    @Override
    void end(TroubledFlight flight) {
      flight.repairEstimator();
    }
  },
  /** The health monitor says that the actuators' service is lost. */
  ACTUATOR_LINK("ON ACTUATOR LINK LOSS", "actuator link") {
    @Override
    void begin(TroubledFlight flight) {
      say(flight, Condition.LOST);
    }

    @Override
    void end(TroubledFlight flight) {
      say(flight, Condition.ALIVE);
    }

    private void say(TroubledFlight flight, Condition condition) {
      flight
          .witness()
          .say(
              Channels.CONDITIONS,
              new ServiceCondition().serviceName("Simulator").condition(condition));
    }
  },
  /** The battery's voltage falls. */
  BATTERY("ON LOW BATTERY", "low battery") {
    @Override
    LaunchOptions configure(LaunchOptions options, FailsafeAction action) {
      return super.configure(options, action)
          .override("SafetyManager", "LOW BATTERY VOLTAGE", 22.0)
          .override("SafetyManager", "BATTERY DEADLINE", 3_600.0); // said once
    }

    @Override
    void prepare(TroubledFlight flight) {
      say(flight, 25.0);
    }

    @Override
    void begin(TroubledFlight flight) {
      say(flight, 21.0);
    }

    @Override
    void end(TroubledFlight flight) {
      say(flight, 25.0);
    }

    private void say(TroubledFlight flight, double volts) {
      flight.witness().say(Channels.POWER, new BatteryState().sensorName("main").voltage(volts));
    }
  };

  private final String variable;
  private final String words;

  Trouble(String variable, String words) {
    this.variable = variable;
    this.words = words;
  }

  /** Whether an action leads somewhere. */
  boolean needsPosition(FailsafeAction action) {
    return action != FailsafeAction.HOLD && action != FailsafeAction.STOP;
  }

  /** How the Safety Manager calls it. */
  String words() {
    return words;
  }

  /** Makes it possible, and sets its row in the matrix. */
  LaunchOptions configure(LaunchOptions options, FailsafeAction action) {
    return options.override("SafetyManager", variable, action.name());
  }

  /** What must be said on the runway. */
  void prepare(TroubledFlight flight) {}

  abstract void begin(TroubledFlight flight) throws InterruptedException;

  abstract void end(TroubledFlight flight);
}
