package org.u2sa.sim.flight;

import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.vehicle.BodyState;

/** Rotors that carry an aircraft, and the drag of its frame. Commands 0…1 scale the speed. */
final class Rotors implements AirLoads {
  private final List<Rotor> rotors;
  private final List<String> names;
  private final Point frameDrag;
  private final double spanM;
  private final double[] target;
  private final double[] kept;

  /**
   * @param frameDrag drag of the frame along each axis [N s²/m²]
   */
  Rotors(List<Rotor> rotors, Point frameDrag) {
    this.rotors = List.copyOf(rotors);
    this.frameDrag = frameDrag;
    names = rotors.stream().map(Rotor::name).toList();
    spanM = 2.0 * rotors.stream().mapToDouble(each -> each.place().distance()).max().orElse(0.0);
    target = new double[rotors.size()];
    kept = new double[rotors.size()];
    Arrays.fill(kept, 1.0);
  }

  @Override
  public List<String> actuators() {
    return names;
  }

  @Override
  public void command(int actuator, double value) {
    Rotor rotor = rotors.get(actuator);
    target[actuator] =
        rotor.maxRadPerS() * Arguments.requireInside("command of " + rotor.name(), value, 0.0, 1.0);
  }

  @Override
  public void weaken(int actuator, double share) {
    kept[actuator] = AirLoads.share(share);
  }

  @Override
  public boolean isDriven() {
    return Arrays.stream(target).anyMatch(speed -> speed > 0.0);
  }

  @Override
  public double spanM() {
    return spanM;
  }

  /** {@inheritDoc} Power of the shafts, computed from the rotors' torque at rest. */
  @Override
  public double powerW(double[] s, int first, Air air) {
    double sum = 0.0;
    for (int i = 0; i < target.length; i++) {
      double omega = s[first + i];
      sum += kept[i] * rotors.get(i).torque() * omega * omega * omega;
    }
    return sum;
  }

  @Override
  public void add(double[] s, double[] rate, int first, Air air, double[] load) {
    double p = s[BodyState.RATES];
    double q = s[BodyState.RATES + 1];
    double r = s[BodyState.RATES + 2];
    for (int i = 0; i < target.length; i++) {
      Rotor rotor = rotors.get(i);
      Point at = rotor.place();
      Point axis = rotor.axis();
      double omega = s[first + i];
      rate[first + i] = (target[i] - omega) / rotor.timeConstantS();
      double u = air.u + q * at.z() - r * at.y(); // velocity of the hub through the air
      double v = air.v + r * at.x() - p * at.z();
      double w = air.w + p * at.y() - q * at.x();
      double along = u * axis.x() + v * axis.y() + w * axis.z();
      double acrossX = u - along * axis.x();
      double acrossY = v - along * axis.y();
      double acrossZ = w - along * axis.z();
      double across2 = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
      double push =
          kept[i] * (rotor.thrust() * omega * omega + rotor.lift() * across2)
              - omega * rotor.inflow() * along;
      double held = omega * rotor.drag();
      double fx = push * axis.x() - held * acrossX;
      double fy = push * axis.y() - held * acrossY;
      double fz = push * axis.z() - held * acrossZ;
      double turn = kept[i] * rotor.spin() * rotor.torque() * omega * omega;
      load[0] += fx;
      load[1] += fy;
      load[2] += fz;
      load[3] += at.y() * fz - at.z() * fy + turn * axis.x();
      load[4] += at.z() * fx - at.x() * fz + turn * axis.y();
      load[5] += at.x() * fy - at.y() * fx + turn * axis.z();
    }
    double speed = air.speedMps();
    load[0] -= speed * frameDrag.x() * air.u;
    load[1] -= speed * frameDrag.y() * air.v;
    load[2] -= speed * frameDrag.z() * air.w;
  }
}
