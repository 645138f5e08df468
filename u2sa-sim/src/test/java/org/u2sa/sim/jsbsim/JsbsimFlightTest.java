package org.u2sa.sim.jsbsim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** The aircraft of trainer.xml, beside JSBSim's flight of it and on the ground. */
class JsbsimFlightTest {
  private static final double FOOT = 0.3048;
  private static final double FRAME_S = 1.0 / 120.0; // after which JSBSim moves a surface
  private static final double ROW_S = 0.5;
  private static final double WITHIN = 0.03; // of the span of a quantity
  private static final Footprint OUTLINE = Footprint.rectangle(2.0, 4.0, 9.0, -1.0, 1.5);
  private static final World LEVEL = World.at(new Geodetic(9.0, 45.0, 0.0));

  /** The aircraft's file in the repository. */
  static Path trainerFile() {
    return Path.of("").toAbsolutePath().getParent().resolve("config/vehicles/trainer/trainer.xml");
  }

  private static JsbsimAircraft trainer() {
    return JsbsimAircraft.read(trainerFile(), Map.of());
  }

  private static List<Map<String, Double>> reference(String name)
      throws IOException, URISyntaxException {
    List<String> lines =
        Files.readAllLines(Path.of(JsbsimFlightTest.class.getResource(name).toURI()));
    String[] names = lines.get(0).split(",");
    List<Map<String, Double>> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      String[] values = line.split(",");
      Map<String, Double> row = new LinkedHashMap<>();
      for (int i = 0; i < names.length; i++) {
        row.put(names[i], Double.parseDouble(values[i]));
      }
      rows.add(row);
    }
    return rows;
  }

  private static void command(UnmannedAircraft aircraft, Map<String, Double> row) {
    aircraft.command("ELEVATOR", row.get("elevator"));
    aircraft.command("AILERON", row.get("aileron"));
    aircraft.command("RUDDER", -row.get("rudder"));
    aircraft.command("THROTTLE", row.get("throttle"));
    aircraft.command("FLAPS", row.get("flap"));
  }

  private static JsbsimFlight begin(Map<String, Double> row) {
    JsbsimFlight flight =
        trainer()
            .flight(
                Map.of(
                    "propulsion/engine/propeller-rpm",
                    row.get("propulsion/engine/propeller-rpm"),
                    "propulsion/engine/map-pa",
                    row.get("propulsion/engine/map-pa")),
                OUTLINE,
                LEVEL,
                Point.of(0.0, 0.0, FOOT * row.get("position/h-sl-ft")),
                0.0);
    flight
        .aircraft()
        .fly(
            new Attitude(
                row.get("attitude/phi-rad"),
                row.get("attitude/theta-rad"),
                row.get("attitude/psi-rad")),
            Point.of(
                FOOT * row.get("velocities/u-fps"),
                FOOT * row.get("velocities/v-fps"),
                FOOT * row.get("velocities/w-fps")));
    return flight;
  }

  private static Map<String, Double> state(JsbsimFlight flight) {
    VehicleTruth truth = flight.aircraft().truth();
    Point enu = truth.velocity();
    Point body =
        truth.attitude().nedFromFrd().transposed().times(Point.of(enu.y(), enu.x(), -enu.z()));
    return Map.ofEntries(
        Map.entry("position/h-sl-ft", truth.position().z() / FOOT),
        Map.entry("velocities/u-fps", body.x() / FOOT),
        Map.entry("velocities/v-fps", body.y() / FOOT),
        Map.entry("velocities/w-fps", body.z() / FOOT),
        Map.entry("attitude/phi-rad", truth.attitude().phi()),
        Map.entry("attitude/theta-rad", truth.attitude().theta()),
        Map.entry("velocities/p-rad_sec", truth.rates().x()),
        Map.entry("velocities/q-rad_sec", truth.rates().y()),
        Map.entry("velocities/r-rad_sec", truth.rates().z()),
        Map.entry(
            "propulsion/engine/propeller-rpm", flight.property("propulsion/engine/propeller-rpm")),
        Map.entry("propulsion/engine/power-hp", flight.property("propulsion/engine/power-hp")),
        Map.entry("propulsion/tank/contents-lbs", flight.property("propulsion/tank/contents-lbs")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"trainer_reference.csv", "trainer_low_reference.csv"})
  void step_commandsOfJsbsim_fliesAsJsbsim(String name) throws IOException, URISyntaxException {
    List<Map<String, Double>> rows = reference(name);
    JsbsimFlight flight = begin(rows.get(0));
    Map<String, Double> worst = new LinkedHashMap<>();
    for (int i = 1; i < rows.size(); i++) {
      command(flight.aircraft(), rows.get(Math.max(0, i - 2)));
      flight.aircraft().step(FRAME_S);
      command(flight.aircraft(), rows.get(i - 1));
      flight.aircraft().step(ROW_S - FRAME_S);
      Map<String, Double> row = rows.get(i);
      state(flight)
          .forEach((key, value) -> worst.merge(key, Math.abs(value - row.get(key)), Math::max));
    }
    worst.forEach(
        (quantity, difference) -> {
          double lowest = rows.stream().mapToDouble(row -> row.get(quantity)).min().orElseThrow();
          double highest = rows.stream().mapToDouble(row -> row.get(quantity)).max().orElseThrow();
          assertThat(difference / (highest - lowest)).as(quantity).isLessThan(WITHIN);
        });
    assertThat(worst).hasSize(12);
  }

  @Test
  void standing_engineIdling_restsWithBrakes() {
    UnmannedAircraft aircraft = trainer().standing(OUTLINE, LEVEL, Point.ORIGIN, 1.0).aircraft();
    Attitude before = aircraft.truth().attitude();
    Point place = aircraft.truth().position();
    aircraft.command("LEFT BRAKE", 1.0);
    aircraft.command("RIGHT BRAKE", 1.0);
    aircraft.step(5.0);
    assertThat(aircraft.stands()).isTrue();
    assertThat(aircraft.truth().position().minus(place).distance()).isLessThan(0.02);
    assertThat(aircraft.truth().attitude().theta()).isCloseTo(before.theta(), within(0.002));
    assertThat(aircraft.truth().headingRad()).isCloseTo(1.0, within(0.01));
  }

  @Test
  void step_rudderRightOnTheRunway_steersRightAndTakesOff() {
    UnmannedAircraft aircraft = trainer().standing(OUTLINE, LEVEL, Point.ORIGIN, 0.0).aircraft();
    aircraft.command("THROTTLE", 1.0);
    aircraft.step(3.0);
    double straight = aircraft.truth().headingRad();
    aircraft.command("RUDDER", 0.3);
    aircraft.step(1.0);
    assertThat(Math.IEEEremainder(aircraft.truth().headingRad() - straight, 2.0 * Math.PI))
        .isGreaterThan(0.01);
    aircraft.command("RUDDER", 0.0);
    aircraft.command("ELEVATOR", -0.25);
    aircraft.step(20.0);
    assertThat(aircraft.isAground()).isFalse();
    assertThat(aircraft.truth().position().z()).isGreaterThan(5.0);
    assertThat(aircraft.energyJ().orElseThrow()).isBetween(0.5e6, 1.8e6);
  }

  @Test
  void step_tankRunsDry_engineStopsAndMassFalls() {
    Map<String, Double> little = Map.of("propulsion/tank[0]/contents-lbs", 0.06);
    JsbsimFlight flight =
        trainer().flight(little, OUTLINE, LEVEL, Point.of(0.0, 0.0, 1_000.0), 0.0);
    flight.aircraft().fly(new Attitude(0.0, 0.0, 0.0), Point.of(45.0, 0.0, 0.0));
    flight.aircraft().command("THROTTLE", 1.0);
    flight.aircraft().step(2.0);
    assertThat(flight.property("propulsion/engine[0]/power-hp")).isGreaterThan(50.0);
    flight.aircraft().step(20.0);
    assertThat(flight.property("propulsion/tank/contents-lbs")).isZero();
    assertThat(flight.property("propulsion/engine/power-hp")).isNegative();
  }

  @Test
  void read_trainer_hasItsActuatorsMassAndTravels() {
    JsbsimAircraft aircraft = trainer();
    assertThat(aircraft.actuators())
        .containsExactly(
            "AILERON", "ELEVATOR", "RUDDER", "THROTTLE", "FLAPS", "LEFT BRAKE", "RIGHT BRAKE");
    assertThat(aircraft.massKg()).isCloseTo(536.5, within(0.5));
    assertThat(aircraft.travelRad("ELEVATOR")).hasValue(0.4);
    assertThat(aircraft.travelRad("THROTTLE")).isEmpty();
    assertThat(aircraft.ignored()).singleElement().asString().contains("<output>");
  }
}
