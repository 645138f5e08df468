package org.u2sa.control.cascade;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.control.Pid;
import org.u2sa.control.RelayTuner;
import org.u2sa.control.allocation.Authority;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Relay auto-tuning of one axis's inner loop, started by a variable, while the other axes are
 * controlled as usual. Reports the gains found; applying them is up to the operator. Not
 * thread-safe.
 */
final class AxisTuner {
  /** The variables. */
  record Order(
      @Variable(
              oneOf = {"", "SURGE", "SWAY", "HEAVE", "ROLL", "PITCH", "YAW"},
              ifAbsentText = "")
          @Description(
              "Axis whose velocity or rate loop is to be tuned by relay feedback, once, while the vehicle is armed; its gains are written to the log.")
          String tune,
      @Variable(unit = "%", min = 1, max = 50, ifAbsent = 15)
          @Description("Share of the axis's authority that the relay uses.")
          double tuneAmplitude,
      @Variable(min = 0, max = 1, ifAbsent = 0.01)
          @Description(
              "Hysteresis of the relay, above the noise of the velocity [m/s] or rate [rad/s].")
          double tuneHysteresis) {}

  private static final double FULL_PERCENT = 100.0;
  private static final double GIVE_UP_AFTER_S = 60.0;

  private final Settings<Order> order;
  private String handled = ""; // last order carried out
  private DegreeOfFreedom axis = DegreeOfFreedom.YAW;
  private RelayTuner relay; // null if not tuning

  AxisTuner(Settings<Order> order) {
    this.order = order;
  }

  /** Aborts tuning because the vehicle is disarmed or its state is incomplete. */
  void abort() {
    relay = null;
  }

  /**
   * Replaces the force or moment of the tuned axis with the relay output.
   *
   * @param armed whether a Safety Manager has reported the vehicle armed
   * @param wrench wanted wrench; modified
   * @return message for the user when tuning starts or ends
   */
  Optional<String> step(
      boolean armed,
      Authority authority,
      double[] wrench,
      double[] measured,
      double mass,
      double stepS) {
    String wanted = order.get().tune();
    Optional<String> words = Optional.empty();
    if (wanted.isEmpty()) {
      handled = "";
      relay = null;
      return words;
    }
    if (!wanted.equals(handled)) {
      handled = wanted;
      words = Optional.of(begin(armed, authority));
    }
    if (relay == null) {
      return words;
    }
    int j = axis.ordinal();
    wrench[j] = relay.step(measured[j], stepS);
    if (relay.found().isPresent()) {
      words =
          Optional.of("relay tuning of " + axis.name() + ": " + gains(relay.found().get(), mass));
      relay = null;
    } else if (relay.hasFailed()) {
      words = Optional.of("relay tuning of " + axis.name() + " found no steady oscillation");
      relay = null;
    }
    return words;
  }

  private String begin(boolean armed, Authority authority) {
    Order now = order.get();
    axis = DegreeOfFreedom.valueOf(now.tune());
    double most = authority.most(axis);
    if (!armed || !(most > 0.0)) {
      return "relay tuning of "
          + axis.name()
          + " refused: "
          + (armed ? "no actuator acts on the axis, or the axis is not controlled" : "not armed");
    }
    double amplitude = now.tuneAmplitude() / FULL_PERCENT * most;
    relay = new RelayTuner(amplitude, now.tuneHysteresis(), GIVE_UP_AFTER_S);
    return "relay tuning of " + axis.name() + " begins";
  }

  /** Axis currently driven by the relay. */
  Optional<DegreeOfFreedom> tuned() {
    return relay == null ? Optional.empty() : Optional.of(axis);
  }

  /** Mass of the tuned axis, by which the gains per acceleration are scaled. */
  DegreeOfFreedom axis() {
    String wanted = order.get().tune();
    return wanted.isEmpty() ? axis : DegreeOfFreedom.valueOf(wanted);
  }

  private String gains(RelayTuner.Found found, double mass) {
    return found
        + "; Tyreus-Luyben PI: "
        + words(found.tyreusLuybenPi(), mass)
        + "; PID: "
        + words(found.tyreusLuybenPid(), mass)
        + "; Ziegler-Nichols PID: "
        + words(found.zieglerNicholsPid(), mass);
  }

  private String words(Pid.Gains gains, double mass) {
    return String.format(
        Locale.ROOT,
        "%s GAIN %.3g 1/s, INTEGRAL TIME %.3g s, DERIVATIVE TIME %.3g s",
        axis.name(),
        gains.gain() / mass,
        gains.integralS(),
        gains.derivativeS());
  }
}
