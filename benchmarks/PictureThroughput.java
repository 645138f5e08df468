package org.u2sa.scenarios.igvc;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Renderer;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Pictures of 640 × 480 pixels that a second of one core's time renders, along the lines of IGVC
 * courses. Run by benchmarks/run with U2SA_BENCHMARKS=org.u2sa.scenarios.igvc.PictureThroughput.
 */
final class PictureThroughput {
  private static final int ROUNDS = 7;
  private static final int PICTURES = 60;
  private static final double SPEED_MPS = 0.9;
  private static final double TURN_RADPS = 0.2;

  public static void main(String[] arguments) {
    System.out.println(
        "| course | pictures/s, median of " + ROUNDS + " | slowest | fastest |\n|---|---|---|---|");
    for (long seed : new long[] {701, 702, 703}) {
      measure(seed, Ramps.NONE);
    }
    measure(3001, Ramps.ALL);
  }

  private static void measure(long seed, Ramps ramps) {
    Course course = CourseGenerator.course(seed, ramps);
    NoiseStreams streams = new NoiseStreams(seed);
    Scenery scenery = new Scenery(course.objects(), Light.random(new Random(seed)), seed);
    Renderer renderer = new Renderer(ColourLens.mast(), scenery, streams);
    List<VehicleTruth> places = places(course);
    double[] rates = new double[ROUNDS];
    int at = 0;
    for (int round = -3; round < ROUNDS; round++) { // the first are for the compiler
      long began = cpuNanos();
      for (int i = 0; i < PICTURES; i++) {
        renderer.picture(places.get(at++ % places.size()));
      }
      if (round >= 0) {
        rates[round] = PICTURES / ((cpuNanos() - began) / 1e9);
      }
    }
    Arrays.sort(rates);
    System.out.printf(
        Locale.ROOT,
        "| %d%s | %.0f | %.0f | %.0f |%n",
        seed,
        ramps == Ramps.ALL ? ", with a ramp" : "",
        rates[ROUNDS / 2],
        rates[0],
        rates[ROUNDS - 1]);
  }

  /** A metre and a half to the right of each line, looking along it. */
  private static List<VehicleTruth> places(Course course) {
    List<VehicleTruth> places = new ArrayList<>();
    course
        .boundaries()
        .forEach(
            line -> {
              for (int i = 0; i + 1 < line.points().size(); i += 2) {
                Point from = line.points().get(i);
                Point to = line.points().get(i + 1);
                double heading = Math.atan2(to.x() - from.x(), to.y() - from.y());
                double sin = Math.sin(heading);
                double cos = Math.cos(heading);
                places.add(
                    new VehicleTruth(
                        0.0,
                        Point.of(from.x() + 1.5 * cos, from.y() - 1.5 * sin, 0.0),
                        new Attitude(0.0, 0.0, (heading + 2.0 * Math.PI) % (2.0 * Math.PI)),
                        Point.of(SPEED_MPS * sin, SPEED_MPS * cos, 0.0),
                        Point.of(0.0, 0.0, TURN_RADPS),
                        Point.ORIGIN));
              }
            });
    return places;
  }

  /** Of all threads: bands of a picture are shared out to all cores. */
  private static long cpuNanos() {
    return ((com.sun.management.OperatingSystemMXBean)
            ManagementFactory.getOperatingSystemMXBean())
        .getProcessCpuTime();
  }
}
