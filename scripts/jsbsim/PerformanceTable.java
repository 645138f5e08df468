import java.util.List;
import java.util.ArrayList;
import java.io.PrintStream;
import java.util.Locale;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.Trim;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.Wind;

/**
 * Prints what the simulated Cessna 172 achieves, as lines {@code kind,condition,quantity,value}:
 * for comparison with other models.
 */
public final class PerformanceTable {
  private static final double KNOT = 1852.0 / 3600.0;
  private static final double FOOT = 0.3048;
  private static final double HORSEPOWER = 745.6999;
  private static final double TEST_ALTITUDE_M = 1_000.0 * FOOT;
  private static final double CRUISE_ALTITUDE_M = 8_000.0 * FOOT;
  private static final double STALL_ALTITUDE_M = 4_000.0 * FOOT;
  private static final double TICK_S = 1.0 / Cessna172.TICKS_PER_SECOND;
  private static final double STICK_PER_S = 0.02;
  private static final double NOSE_DROPS_RAD_PER_S = -0.05;

  private final PrintStream out;

  private PerformanceTable(PrintStream out) {
    this.out = out;
  }

  /** Prints to standard output; takes no arguments. */
  public static void main(String[] arguments) {
    new PerformanceTable(System.out).print();
  }

  private void print() {
    out.println("kind,condition,quantity,value");
    for (double knots : new double[] {60.0, 70.0, 80.0, 90.0, 100.0, 110.0}) {
      String condition = String.format(Locale.ROOT, "%.0f KCAS 1000 ft", knots);
      Trim trim = Trim.level(TEST_ALTITUDE_M, trueSpeed(TEST_ALTITUDE_M, knots), 0.0);
      row("level", condition, "alpha deg", Math.toDegrees(trim.angleOfAttackRad()));
      row("level", condition, "elevator deg", elevatorDeg(trim.controls()));
      row("level", condition, "power hp", trim.shaftPowerW() / HORSEPOWER);
      row("level", condition, "rpm", trim.engineRpm());
    }
    for (double knots : new double[] {65.0, 75.0, 85.0, 95.0}) {
      String condition = String.format(Locale.ROOT, "%.0f KCAS sea level full throttle", knots);
      Trim trim = Trim.atThrottle(0.0, trueSpeed(0.0, knots), 1.0, 0.0);
      row("climb", condition, "ft/min", trim.climbMps() / FOOT * 60.0);
      row("climb", condition, "rpm", trim.engineRpm());
    }
    Trim glide = Trim.atThrottle(TEST_ALTITUDE_M, trueSpeed(TEST_ALTITUDE_M, 65.0), 0.0, 0.0);
    row("glide", "65 KCAS idle", "ft/min", glide.climbMps() / FOOT * 60.0);
    row("cruise", "8000 ft full throttle", "KTAS", fastest(CRUISE_ALTITUDE_M) / KNOT);
    row("cruise", "sea level full throttle", "KTAS", fastest(0.0) / KNOT);
    row("stall", "idle flaps 0", "KCAS", stall(0.0));
    row("stall", "idle flaps 30", "KCAS", stall(1.0));
    for (double knots : new double[] {80.0, 100.0}) {
      String condition = String.format(Locale.ROOT, "%.0f KCAS bank 30 deg", knots);
      Trim turn = Trim.turning(TEST_ALTITUDE_M, trueSpeed(TEST_ALTITUDE_M, knots), Math.PI / 6.0);
      row("turn", condition, "deg/s", flownTurn(turn));
      row("turn", condition, "power hp", turn.shaftPowerW() / HORSEPOWER);
      row("turn", condition, "alpha deg", Math.toDegrees(turn.angleOfAttackRad()));
    }
    modes();
  }

  /** Pulses from trim at 100 KCAS; the wings are held level while the phugoid swings. */
  private void modes() {
    String condition = "100 KCAS 1000 ft";
    Trim trim = Trim.level(TEST_ALTITUDE_M, trueSpeed(TEST_ALTITUDE_M, 100.0), 0.0);
    ControlInputs held = trim.controls();
    Cessna172 swinging = Cessna172.inFlight(trim.start(0.0, 0.0, 0.0, 0.0), Wind.calm());
    swinging.step(held.withSurfaces(held.aileron(), held.elevator() - 0.06, held.rudder()), 2.0);
    Oscillation phugoid = new Oscillation();
    while (swinging.state().timeS() < 122.0) {
      AircraftMotion state = swinging.state();
      if (state.timeS() > 7.0) {
        phugoid.add(state.timeS(), state.trueAirspeedMps());
      }
      double aileron = held.aileron() - 3.0 * state.rollRad() - 0.5 * state.rollRateRadPerS();
      swinging.step(held.withSurfaces(aileron, held.elevator(), held.rudder()), TICK_S);
    }
    row("modes", condition, "phugoid period s", phugoid.periodS());
    row("modes", condition, "phugoid damping ratio", phugoid.dampingRatio());
    Cessna172 rolling = Cessna172.inFlight(trim.start(0.0, 0.0, 0.0, 0.0), Wind.calm());
    rolling.step(held.withSurfaces(held.aileron(), held.elevator(), held.rudder() + 0.3), 1.0);
    Oscillation dutchRoll = new Oscillation();
    while (rolling.state().timeS() < 11.0) {
      rolling.step(held, TICK_S);
      dutchRoll.add(rolling.state().timeS(), rolling.state().yawRateRadPerS());
    }
    row("modes", condition, "Dutch roll period s", dutchRoll.periodS());
    row("modes", condition, "Dutch roll damping ratio", dutchRoll.dampingRatio());
  }

  private void row(String kind, String condition, String quantity, double value) {
    out.printf(Locale.ROOT, "%s,%s,%s,%.3f%n", kind, condition, quantity, value);
  }

  private static double trueSpeed(double altitudeM, double calibratedKnots) {
    return StandardAtmosphere.at(altitudeM).trueAirspeedMps(calibratedKnots * KNOT);
  }

  private static double elevatorDeg(ControlInputs inputs) {
    double travel = inputs.elevator() < 0.0 ? Math.toRadians(28.0) : Math.toRadians(23.0);
    return Math.toDegrees(inputs.elevator() * travel);
  }

  /**
   * Level at full throttle, by bisection between a speed that climbs and one that cannot be held.
   */
  private static double fastest(double altitudeM) {
    double low = 45.0;
    double high = 80.0;
    for (int i = 0; i < 40; i++) {
      double middle = 0.5 * (low + high);
      if (Trim.atThrottle(altitudeM, middle, 1.0, 0.0).flightPathRad() > 0.0) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /**
   * Idle, the stick comes back slowly and the wings are held level: lowest speed before the nose
   * drops.
   */
  private static double stall(double flaps) {
    Trim trim = Trim.atThrottle(STALL_ALTITUDE_M, trueSpeed(STALL_ALTITUDE_M, 65.0), 0.0, flaps);
    Cessna172 aircraft = Cessna172.inFlight(trim.start(0.0, 0.0, 0.0, 0.0), Wind.calm());
    double lowest = Double.MAX_VALUE;
    double stick = trim.controls().elevator();
    while (stick > -1.0) {
      AircraftMotion state = aircraft.state();
      if (state.pitchRateRadPerS() < NOSE_DROPS_RAD_PER_S) {
        break;
      }
      lowest = Math.min(lowest, state.calibratedAirspeedMps());
      stick = Math.max(-1.0, stick - STICK_PER_S / Cessna172.TICKS_PER_SECOND);
      double aileron = -2.0 * state.rollRad() - 0.5 * state.rollRateRadPerS();
      double rudder = -state.yawRateRadPerS();
      aircraft.step(
          ControlInputs.limited(aileron, stick, rudder, 0.0, 1.0, flaps, 0.0, 0.0), TICK_S);
    }
    return lowest / KNOT;
  }

  /**
   * Flies the turn and measures it: bank and height held, no sideslip. Mean over 20 s after 20 s.
   */
  private static double flownTurn(Trim trim) {
    Cessna172 aircraft = Cessna172.inFlight(trim.start(0.0, 0.0, 0.0, 0.0), Wind.calm());
    double turned = 0.0;
    AircraftMotion before = aircraft.state();
    for (int tick = 0; tick < 40 * Cessna172.TICKS_PER_SECOND; tick++) {
      double climb = -before.velocityDownMps();
      double height = before.altitudeM() - trim.altitudeM();
      double aileron =
          trim.controls().aileron()
              + 2.0 * (trim.rollRad() - before.rollRad())
              - 0.5 * before.rollRateRadPerS();
      double elevator = trim.controls().elevator() + 0.02 * climb + 0.005 * height;
      double rudder = trim.controls().rudder() + 2.0 * before.sideslipRad();
      aircraft.step(
          ControlInputs.limited(
              aileron, elevator, rudder, trim.controls().throttle(), 1.0, 0.0, 0.0, 0.0),
          TICK_S);
      AircraftMotion after = aircraft.state();
      if (before.timeS() >= 20.0) {
        turned += StrictMath.IEEEremainder(after.headingRad() - before.headingRad(), 2.0 * Math.PI);
      }
      before = after;
    }
    return Math.toDegrees(turned) / 20.0;
  }

  /**
   * Period and damping of a decaying oscillation, read from its peaks as a flight-test engineer does.
   */
  private static final class Oscillation {
    private static final int PEAKS_NEEDED = 4;

    private record Sample(double timeS, double value) {}

    private final List<Sample> peaks = new ArrayList<>();
    private Sample before;
    private Sample last;

    void add(double timeS, double value) {
      Sample sample = new Sample(timeS, value);
      if (before != null && (last.value - before.value) * (value - last.value) < 0.0) {
        peaks.add(last);
      }
      before = last;
      last = sample;
    }

    /** Of the first one and a half swings [s]; NaN if there were fewer. */
    double periodS() {
      return peaks.size() < PEAKS_NEEDED
          ? Double.NaN
          : 2.0 * (peaks.get(3).timeS - peaks.get(0).timeS) / 3.0;
    }

    /**
     * From the logarithmic decrement of peak-to-peak spans half a period apart; NaN if there were too
     * few.
     */
    double dampingRatio() {
      if (peaks.size() < PEAKS_NEEDED) {
        return Double.NaN;
      }
      double decrement = StrictMath.log(span(0) / span(2)) / 2.0;
      return decrement / StrictMath.hypot(Math.PI, decrement);
    }

    private double span(int index) {
      return Math.abs(peaks.get(index + 1).value - peaks.get(index).value);
    }
  }
}
