package org.u2sa.sim.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Vehicle files of the tests, and those that are shipped. */
final class Vehicles {
  static final Path MINI_MOLLE = Path.of("../config/ugv/vehicle.xml");
  static final Path BLUEROV2 = Path.of("../config/vehicles/bluerov2.xml");
  static final Path OTTER = Path.of("../config/vehicles/otter.xml");
  static final Path WAMV = Path.of("../config/vehicles/wamv.xml");
  static final Path REMUS_100 = Path.of("../config/vehicles/remus100.xml");

  static final Path AEROSONDE = Path.of("../config/suas/plane/vehicle.xml");

  static final Path TRUCK = Path.of("../config/ugv/vehicle-ackermann.xml");

  private Vehicles() {}

  static String sixWheels() {
    return resource("six-wheels.xml");
  }

  static String threeThrusters() {
    return resource("three-thrusters.xml");
  }

  private static String resource(String name) {
    try (InputStream in = Vehicles.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static VehicleFile parse(String text) {
    return VehicleFile.read(
        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "vehicle.xml");
  }
}
