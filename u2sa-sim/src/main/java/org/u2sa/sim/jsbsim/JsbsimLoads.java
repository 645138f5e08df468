package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.flight.Air;
import org.u2sa.sim.flight.AirLoads;
import org.u2sa.sim.flight.MassProperties;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.Arguments;

/** All loads on one aircraft in JSBSim's format. Not thread-safe. */
final class JsbsimLoads implements AirLoads {
  private static final int WEIGHED_EVERY_TICKS = 400;
  private static final double DRIVEN_ABOVE = 0.5;

  private final PropertyTree properties;
  private final AirFlow flow;
  private final MassBalance mass;
  private final AxisLoads aerodynamics;
  private final FlightControl control;
  private final List<PowerPlant> plants = new ArrayList<>();
  private final GroundContacts contacts;
  private final List<String> actuators = new ArrayList<>();
  private final double[] commands;
  private final double[] kept;
  private final double[] loads = new double[6]; // [lbf, lbf ft]
  private Optional<MassProperties> weighed;
  private int ticks;

  JsbsimLoads(AircraftFiles files, PropertyTree properties) {
    this.properties = properties;
    FunctionReader functions = new FunctionReader(properties);
    for (ControlLever each : ControlLever.values()) {
      each.define(properties);
    }
    XmlElement propulsion = files.propulsion();
    flow = new AirFlow(properties, files.section("metrics"));
    mass = new MassBalance(files.section("mass_balance"), propulsion.children("tank"), properties);
    weighed = Optional.of(mass.update());
    contacts = new GroundContacts(files.section("ground_reactions"), mass);
    List<XmlElement> engines = propulsion.children("engine");
    for (int i = 0; i < engines.size(); i++) {
      plants.add(
          new PowerPlant(
              properties,
              i,
              engines.get(i),
              files.engine(engines.get(i)),
              files.propeller(engines.get(i))));
      plants.get(i).load(flow, mass.centre(), loads);
    }
    control = new FlightControl(properties, functions);
    files.systems().forEach(control::read);
    aerodynamics = new AxisLoads(files.section("aerodynamics"), properties, functions);
    properties.requireDefined();
    for (ControlLever each : ControlLever.values()) {
      if (each.isNeeded(properties, !plants.isEmpty(), contacts.hasBrakes())) {
        actuators.add(each.actuator());
      }
    }
    commands = new double[actuators.size()];
    kept = new double[actuators.size()];
    Arrays.fill(kept, 1.0);
  }

  MassProperties start() {
    return weighed.orElseThrow();
  }

  List<Wheel> wheels() {
    return contacts.wheels();
  }

  List<String> ignored() {
    return contacts.ignored();
  }

  /** Largest angles of the surfaces, by actuator [rad]; leaves the surfaces at full deflection. */
  Map<String, Double> travels(double longS) {
    Map<String, Double> travels = new HashMap<>();
    for (double command : new double[] {-1.0, 1.0}) {
      for (ControlLever each : ControlLever.values()) {
        each.apply(properties, Math.max(each.lowest(), command), plants.size());
      }
      control.step(longS);
      for (ControlLever each : ControlLever.values()) {
        double angle = Math.abs(each.angleRad(properties).orElse(0.0));
        if (angle > 0.0 && actuators.contains(each.actuator())) {
          travels.merge(each.actuator(), angle, Math::max);
        }
      }
    }
    return travels;
  }

  double property(String name) {
    return properties.get(name);
  }

  @Override
  public List<String> actuators() {
    return actuators;
  }

  @Override
  public void command(int actuator, double value) {
    String name = actuators.get(actuator);
    double least = ControlLever.of(name).lowest();
    commands[actuator] = Arguments.requireInside("command of " + name, value, least, 1.0);
  }

  @Override
  public void weaken(int actuator, double share) {
    kept[actuator] = AirLoads.share(share);
  }

  @Override
  public boolean isDriven() {
    return lever(ControlLever.THROTTLE) > DRIVEN_ABOVE;
  }

  @Override
  public double spanM() {
    return flow.spanM();
  }

  /** {@inheritDoc} Power of the engines' shafts. */
  @Override
  public double powerW(double[] s, int first, Air air) {
    return plants.stream().mapToDouble(each -> Math.max(0.0, each.powerHp())).sum()
        * UnitNumbers.W_PER_HP;
  }

  private double lever(ControlLever lever) {
    int index = actuators.indexOf(lever.actuator());
    return index < 0 ? 0.0 : kept[index] * commands[index];
  }

  @Override
  public void tick(double[] s, double[] rate, int first, Air air, double dtS) {
    for (ControlLever each : ControlLever.values()) {
      each.apply(properties, lever(each), plants.size());
    }
    for (int i = 0; i < actuators.size(); i++) {
      s[first + i] = kept[i] * commands[i];
    }
    control.step(dtS);
    contacts.set(
        lever(ControlLever.RUDDER),
        lever(ControlLever.LEFT_BRAKE),
        lever(ControlLever.RIGHT_BRAKE));
    flow.update(s, air, mass.centre());
    flow.accelerate(rate);
    aerodynamics.step(flow);
    for (PowerPlant each : plants) {
      each.load(flow, mass.centre(), loads);
      each.step(flow, dtS);
    }
    if (++ticks % WEIGHED_EVERY_TICKS == 0) {
      weighed = Optional.of(mass.update());
    }
  }

  @Override
  public Optional<MassProperties> mass() {
    return weighed;
  }

  @Override
  public void add(double[] s, double[] rate, int first, Air air, double[] load) {
    Arrays.fill(rate, first, first + actuators.size(), 0.0);
    Arrays.fill(loads, 0.0);
    flow.update(s, air, mass.centre());
    for (PowerPlant each : plants) {
      each.load(flow, mass.centre(), loads);
    }
    aerodynamics.load(flow, mass.centre(), loads);
    for (int i = 0; i < load.length; i++) {
      load[i] += loads[i] * (i < 3 ? UnitNumbers.N_PER_LBF : UnitNumbers.NM_PER_FTLBF);
    }
  }
}
