package org.u2sa.scenarios.vrx;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Reads the sequence of a light buoy, which shows each of three colours for one second and then
 * stays dark for two, and enters the sequence in the current {@link DockBySign} once two
 * consecutive readings agree. In: goals. Out: goal-updates.
 */
final class LightReader extends PeriodicService {
  private static final double LOOKS_PER_S = 10.0;
  private static final int COLOURS = 3;
  private static final double DARK_S = 1.5; // dark time before a sequence
  private static final double COLOUR_S = 1.0;

  /** A camera that recognises the colour of a light. */
  @FunctionalInterface
  interface Sight {
    /** Colour at a time of the run [s]; empty: dark, or out of sight. */
    Optional<Colour> colour(double timeS);
  }

  private final Sight sight;
  private final List<Map<Colour, Integer>> counts = new ArrayList<>(); // of each second
  private Optional<DockBySign> goal = Optional.empty(); // current goal without a sequence
  private List<Colour> lastRead = List.of();
  private double litS; // when the newest light was seen
  private double startS = Double.NaN; // start of the sequence being read

  LightReader(ServiceContext context, Sight sight) {
    super(context, ServiceRole.OBSERVER, "LightReader", LOOKS_PER_S);
    this.sight = sight;
    registerSubscriber(Channels.GOALS);
    registerPublisher(Channels.GOAL_UPDATES);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof GoalList goals) {
      goal =
          goals.goals().stream()
              .filter(DockBySign.class::isInstance)
              .map(DockBySign.class::cast)
              .filter(each -> each.sequence().isEmpty())
              .findFirst();
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    Optional<Colour> colour = sight.colour(nowS);
    if (colour.isEmpty()) {
      if (nowS - litS > DARK_S && !Double.isNaN(startS)) {
        end();
      }
      return;
    }
    if (nowS - litS > DARK_S) {
      startS = nowS;
    }
    litS = nowS;
    int second = Double.isNaN(startS) ? COLOURS : (int) ((nowS - startS) / COLOUR_S);
    while (second < COLOURS && counts.size() <= second) {
      counts.add(new EnumMap<>(Colour.class));
    }
    if (second < COLOURS) {
      counts.get(second).merge(colour.get(), 1, Integer::sum);
    }
  }

  private void end() {
    List<Colour> read = new ArrayList<>();
    for (Map<Colour, Integer> second : counts) {
      second.entrySet().stream()
          .max(Map.Entry.comparingByValue())
          .ifPresent(most -> read.add(most.getKey()));
    }
    startS = Double.NaN;
    counts.clear();
    if (read.size() == COLOURS && read.equals(lastRead) && goal.isPresent()) {
      log("reads " + read);
      publish(Channels.GOAL_UPDATES, goal.get().copy().sequence(read));
      goal = Optional.empty();
    }
    lastRead = read;
  }
}
