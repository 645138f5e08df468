package org.u2sa.sim.ground;

import java.util.List;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.world.Footprint;

/**
 * Skid-steered vehicle with any number of driven wheels per side. It turns by dragging its tyres
 * sideways, so turns cost much more power than with a castor. The wheels' suspensions are equally
 * stiff: the load varies linearly over the ground they cover. Slopes transfer weight between the
 * wheels; acceleration does not. A wheel about to lift carries 1 N.
 */
public final class SkidSteerVehicle extends PlanarVehicle {
  private final SkidSteerParameters p;
  private final DrivenWheel[] wheels; // left and right of each axle, axle by axle
  private final double meanX; // of the axles, relative to the centre of gravity [m]
  private final double squareX; // sum of the wheels' squared distances from it [m²]
  private final double squareY;

  /**
   * Creates a vehicle at rest on a lawn, with a full battery.
   *
   * @throws IllegalArgumentException if a wheel carries no load on level ground
   */
  public SkidSteerVehicle(SkidSteerParameters p, GroundStart start) {
    super(
        start,
        FREE + 2 * p.axlesM().size() * DrivenWheel.SIZE,
        new Chassis(p.massKg(), p.yawInertiaKgM2(), p.cogAheadM(), 0.0),
        new Battery(p.battery()));
    this.p = p;
    wheels = new DrivenWheel[2 * p.axlesM().size()];
    meanX =
        p.axlesM().stream().mapToDouble(Double::doubleValue).average().orElseThrow()
            - p.cogAheadM();
    double square = 0.0;
    for (int i = 0; i < wheels.length; i++) {
      double x = p.axlesM().get(i / 2) - p.cogAheadM();
      double y = i % 2 == 0 ? -p.trackM() / 2.0 : p.trackM() / 2.0;
      wheels[i] =
          new DrivenWheel(
              x, y, MIN_LOAD_N, p.wheelRadiusM(), p.wheelInertiaKgM2(), p.motor(), p.tyre());
      square += (x - meanX) * (x - meanX);
    }
    squareX = square;
    squareY = wheels.length * p.trackM() * p.trackM() / 4.0;
    for (int i = 0; i < wheels.length; i++) {
      double newtons = loadN(wheels[i], 1.0, 0.0, 0.0);
      if (!(newtons > 0.0)) {
        throw new IllegalArgumentException(
            String.format(
                "axle %s m: its wheels would carry %.1f N each; expected a centre of gravity between the axles",
                p.axlesM().get(i / 2), newtons));
      }
    }
    lean(1.0, 0.0, 0.0);
  }

  /** Load that balances the weight and its moments at the height of the centre of gravity. */
  private double loadN(DrivenWheel wheel, double pressing, double forward, double right) {
    double ahead = (forward * p.cogHeightM() - pressing * meanX) / squareX * (wheel.x - meanX);
    double aside = right * p.cogHeightM() / squareY * wheel.y;
    return p.massKg() * Gravity.STANDARD_MPS2 * (pressing / wheels.length + ahead + aside);
  }

  @Override
  void lean(double pressing, double forward, double right) {
    for (DrivenWheel wheel : wheels) {
      wheel.load(Math.max(MIN_LOAD_N, loadN(wheel, pressing, forward, right)));
    }
  }

  @Override
  void prepare(DriveCommand command) {
    for (int i = 0; i < wheels.length; i++) {
      double share =
          i % 2 == 0
              ? command.first() * (1.0 - p.mismatch())
              : command.second() * (1.0 + p.mismatch());
      wheels[i].command(Math.max(-1.0, Math.min(1.0, share))); // NaN stays NaN
    }
    int pairs = wheels.length / 2;
    DrivenWheel left = wheels[0];
    DrivenWheel right = wheels[1];
    double volts =
        battery.volts( // equal motors in parallel are one of a fraction of the resistance
            left.duty(),
            left.emfV(spin(0)),
            pairs * left.perOhm(),
            right.duty(),
            right.emfV(spin(1)),
            pairs * right.perOhm());
    double drawnA = 0.0;
    for (int i = 0; i < wheels.length; i++) {
      DrivenWheel wheel = wheels[i];
      wheel.supply(volts);
      drawnA += wheel.drawnA(s[at(i) + DrivenWheel.SPIN]);
      double east = eastOf(wheel.x, wheel.y);
      double north = northOf(wheel.x, wheel.y);
      wheel.ground(surface.grip(east, north), surface.rollingResistance(east, north));
    }
    battery.draw(drawnA, TICK_S);
  }

  private static int at(int wheel) {
    return FREE + wheel * DrivenWheel.SIZE;
  }

  /** Mean spin of a side's wheels [rad/s]; 0: left, 1: right. */
  private double spin(int side) {
    double sum = 0.0;
    for (int i = side; i < wheels.length; i += 2) {
      sum += s[at(i) + DrivenWheel.SPIN];
    }
    return 2.0 * sum / wheels.length;
  }

  @Override
  void derive(double[] state, double[] rates) {
    for (int i = 0; i < wheels.length; i++) {
      rolling(wheels[i], at(i), state, rates);
      moment(wheels[i].scrubNm);
    }
  }

  @Override
  void bound(FastestRate rate) {
    for (int i = 0; i < wheels.length; i++) {
      rate.add(wheels[i], s[at(i) + DrivenWheel.SPIN]);
    }
  }

  @Override
  void settle() {
    for (int i = 0; i < wheels.length; i++) {
      wheels[i].settle(s, at(i), TICK_S);
    }
  }

  @Override
  boolean idle() {
    return wheels[0].idle() && wheels[1].idle();
  }

  @Override
  void halt() {
    for (int i = 0; i < wheels.length; i++) {
      wheels[i].halt(s, at(i));
    }
  }

  @Override
  public List<String> actuators() {
    return List.of("LEFT MOTOR", "RIGHT MOTOR");
  }

  @Override
  public Footprint footprint() {
    return p.footprint();
  }

  /** {@inheritDoc} Spin, rotation and current are the means of a side's wheels. */
  @Override
  public GroundState state() {
    return state(spin(0), spin(1), angle(0), angle(1), 0.0, current(0), current(1));
  }

  private double angle(int side) {
    double sum = 0.0;
    for (int i = side; i < wheels.length; i += 2) {
      sum += wheels[i].angleRad();
    }
    return 2.0 * sum / wheels.length;
  }

  private double current(int side) {
    double sum = 0.0;
    for (int i = side; i < wheels.length; i += 2) {
      sum += wheels[i].currentA(s[at(i) + DrivenWheel.SPIN]);
    }
    return 2.0 * sum / wheels.length;
  }
}
