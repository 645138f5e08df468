package org.u2sa.scenarios.barn;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Drives BARN worlds in sequence and prints the table of {@code docs/path-planning.md}; {@code
 * scripts/barn/run} starts it.
 */
final class BarnMain {
  /** Width of the demo's rover [m]. */
  private static final double ROVER_WIDTH_M = 0.52;

  /** Its default speed: PLANNED SPEED, and CRUISE SPEED of its control [m/s]. */
  private static final double TOP_MPS = 1.0;

  private static final int WORLDS = 300;

  /** Results of the challenge at ICRA 2022 in simulation, by their authors: 50 worlds, ten runs. */
  private static final String PUBLISHED =
      """
      published for the Jackal (2 m/s, another simulator and laser):
        DRL-VO, first in simulation                metric 0.2339
        DWA of the challenge, reached 88 %         metric 0.1693""";

  private BarnMain() {}

  /**
   * Drives worlds.
   *
   * @param args folder of the worlds, folder for results, numbers of worlds (such as 7,12, or 0/6
   *     for every sixth from 0), factor on the scale for the vehicle's width (1 gives the same
   *     relative width as for the challenge's robot), options of the demo
   */
  public static void main(String[] args) throws IOException {
    if (args.length < 4) {
      throw new IllegalArgumentException(
          args.length + " arguments; expected WORLDS OUT NUMBERS WIDER [OPTION...]");
    }
    Path worlds = Path.of(args[0]);
    Path out = Path.of(args[1]);
    double scale = Double.parseDouble(args[3]) * ROVER_WIDTH_M / BarnCourse.JACKAL_WIDTH_M;
    List<String> options = List.of(args).subList(4, args.length);
    List<BarnScore> scores = new ArrayList<>();
    System.out.println("world  outcome       way m   time s  metric");
    for (int number : numbers(args[2])) {
      BarnCourse course = new BarnCourse(BarnWorld.read(worlds, number), scale);
      BarnScore score = BarnDrive.drive(course, out.resolve("world-" + number), options);
      scores.add(score);
      System.out.println(score.line(TOP_MPS));
    }
    System.out.println(summary(scores));
    System.out.println(PUBLISHED);
    System.exit(0); // even if a demo left threads behind
  }

  private static int[] numbers(String text) {
    String[] stepped = text.split("/");
    if (stepped.length == 2) {
      int step = Integer.parseInt(stepped[1]);
      return IntStream.iterate(Integer.parseInt(stepped[0]), n -> n < WORLDS, n -> n + step)
          .toArray();
    }
    return Stream.of(text.split(",")).mapToInt(Integer::parseInt).toArray();
  }

  private static String summary(List<BarnScore> scores) {
    long reached = count(scores, BarnScore.Outcome.REACHED);
    double metric = scores.stream().mapToDouble(score -> score.metric(TOP_MPS)).average().orElse(0);
    return String.format(
        Locale.ROOT,
        "reached %d of %d, touched %d, not reached %d; metric %.4f of %.2f at %.1f m/s",
        reached,
        scores.size(),
        count(scores, BarnScore.Outcome.TOUCHED),
        count(scores, BarnScore.Outcome.NOT_REACHED),
        metric,
        BarnScore.BEST,
        TOP_MPS);
  }

  private static long count(List<BarnScore> scores, BarnScore.Outcome outcome) {
    return scores.stream().filter(score -> score.outcome() == outcome).count();
  }
}
