package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;

/** An engine with its propeller and the tanks that feed it. */
final class PowerPlant {
  private static final double IDLES = 2.0; // initial speed over idling speed

  private final PropertyTree properties;
  private final String prefix; // prefix of its properties
  private final TabulatedPropeller propeller;
  private final Optional<PistonPower> piston; // empty: electric
  private final double electricHp;
  private final PropertyTree.Property throttle;
  private final PropertyTree.Property mixture;
  private final PropertyTree.Property advance;
  private final List<PropertyTree.Property> tanks = new ArrayList<>();
  private double powerHp;

  /**
   * @param engine the aircraft file's element
   * @param file the engine's own file
   * @param propellerFile the propeller's own file
   */
  PowerPlant(
      PropertyTree properties,
      int number,
      XmlElement engine,
      XmlElement file,
      XmlElement propellerFile) {
    this.properties = properties;
    engine.refuseUnknownChildren("feed thruster location orient description".split(" "));
    prefix = "propulsion/engine[" + number + "]/";
    propeller =
        new TabulatedPropeller(
            properties, prefix, engine.child("thruster").orElseThrow(), propellerFile);
    if (file.name().equals("electric_engine")) {
      file.refuseUnknownChildren("power", "description");
      piston = Optional.empty();
      electricHp = UnitNumbers.number(file, "power", "WATTS") / UnitNumbers.W_PER_HP;
    } else {
      piston = Optional.of(new PistonPower(file));
      electricHp = 0.0;
    }
    String index = "[" + number + "]";
    throttle = properties.define("fcs/throttle-pos-norm" + index, 0.0);
    mixture = properties.define("fcs/mixture-pos-norm" + index, 1.0);
    advance = properties.define("fcs/advance-pos-norm" + index, 1.0);
    for (XmlElement feed : engine.children("feed")) {
      String tank =
          "propulsion/tank[" + (int) UnitNumbers.plain(feed, feed.text()) + "]/contents-lbs";
      if (!properties.isDefined(tank)) {
        throw feed.error("\"" + feed.text() + "\": expected the number of a <tank>, from 0");
      }
      tanks.add(properties.define(tank, 0.0));
    }
    double idle = piston.map(PistonPower::idleRpm).orElse(0.0) * IDLES;
    double start = idle / propeller.gearRatio();
    propeller.spin(properties.define(prefix + "propeller-rpm", start).value);
    piston.ifPresent(
        each -> each.fill(properties.define(prefix + "map-pa", each.manifoldPa()).value));
    publish();
  }

  /** Shaft power [hp]; negative while the propeller drives it. */
  double powerHp() {
    return powerHp;
  }

  /** Adds force and moment in body axes [lbf, lbf ft] and publishes its effect on the tail. */
  void load(AirFlow flow, double[] gravityCentre, double[] load) {
    propeller.load(flow, gravityCentre, powerHp, load);
  }

  /** Runs the engine, burns fuel and turns the propeller. */
  void step(AirFlow flow, double dtS) {
    double lever = Math.max(0.0, Math.min(1.0, throttle.value));
    long full = tanks.stream().filter(tank -> tank.value > 0.0).count();
    powerHp =
        piston
            .map(
                each ->
                    each.powerHp(flow, propeller.engineRpm(), lever, mixture.value, full > 0, dtS))
            .orElse(electricHp * lever);
    double fuel = piston.map(PistonPower::fuelLbPerS).orElse(0.0) * dtS;
    for (PropertyTree.Property tank : tanks) {
      tank.value = tank.value > 0.0 ? Math.max(0.0, tank.value - fuel / full) : tank.value;
    }
    propeller.turn(powerHp, flow.density, advance.value, dtS);
    publish();
  }

  private void publish() {
    properties.set(prefix + "power-hp", powerHp);
    piston.ifPresent(each -> properties.set(prefix + "map-pa", each.manifoldPa()));
  }
}
