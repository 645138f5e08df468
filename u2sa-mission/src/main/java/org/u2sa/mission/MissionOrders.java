package org.u2sa.mission;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.AnsweredOrders;

/**
 * Executes operators' orders to a Mission Manager and reports the results. Idempotent: a repeated
 * order is answered again but not executed again.
 */
final class MissionOrders {
  /** Orders that do not lead the vehicle anywhere at once, unless they say so. */
  private static final Set<MissionAction> PLANNING =
      EnumSet.of(
          MissionAction.SKIP,
          MissionAction.INSERT,
          MissionAction.UPDATE,
          MissionAction.PAUSE,
          MissionAction.REPLACE);

  private final MissionRun run;
  private final Resumable resumable;
  private final MessageTypes types;
  private final Logger logger;
  private final Supplier<List<GoalInformation>> landing;
  private final Supplier<Optional<Waypoint>> returning;
  private final Function<Waypoint, Optional<List<Waypoint>>> way;
  private final Consumer<Mission> replacement;
  private static final String ANSWERED = "ANSWERED ORDERS";

  private final Function<MissionOrder, Optional<String>> lateness;
  private final AnsweredOrders<MissionOrderResult> answered = new AnsweredOrders<>();

  /**
   * @param landing goals of the LAND MISSION
   * @param returning nearest return place
   * @param way waypoints that lead to a given one within the fence
   * @param replacement begins another mission
   * @param lateness reason for refusing an order that arrived too late
   */
  MissionOrders(
      MissionRun run,
      Resumable resumable,
      MessageTypes types,
      Logger logger,
      Supplier<List<GoalInformation>> landing,
      Supplier<Optional<Waypoint>> returning,
      Function<Waypoint, Optional<List<Waypoint>>> way,
      Consumer<Mission> replacement,
      Function<MissionOrder, Optional<String>> lateness) {
    this.lateness = lateness;
    this.run = run;
    this.resumable = resumable;
    this.types = types;
    this.logger = logger;
    this.replacement = replacement;
    this.landing = landing;
    this.returning = returning;
    this.way = way;
  }

  /**
   * Executes an order unless already done. Returns the answer of the manager of that name.
   *
   * @param changed called if the order was executed
   */
  MissionOrderResult obey(MissionOrder order, String manager, Runnable changed) {
    Optional<MissionOrderResult> before = answered.to(order.requestId(), order);
    if (before.isPresent() && order.action() != MissionAction.PAUSE) { // pausing again harms nobody
      return before.get();
    }
    MissionOrderResult result =
        new MissionOrderResult().requestId(order.requestId()).serviceName(manager);
    try {
      String outcome = outcome(order);
      logger.log(LogLevelEnum.INFO, order.action() + " by " + order.operator() + ": " + outcome);
      result.accepted(true).outcome(outcome);
      answered.remember(order.requestId(), order, result); // before it is saved for a successor
      changed.run();
    } catch (BadInputException e) {
      logger.log(
          LogLevelEnum.WARN,
          order.action() + " by " + order.operator() + " refused: " + e.getMessage());
      result.accepted(false).outcome(e.getMessage());
      answered.remember(order.requestId(), order, result);
    }
    return result;
  }

  void handOver(HandOver state) {
    answered.handOver(state, ANSWERED);
  }

  void takeOver(HandOver state) {
    answered.takeOver(state, ANSWERED, MissionOrderResult.class);
  }

  private String outcome(MissionOrder order) {
    if (order.action() != MissionAction.PAUSE) { // pausing is never refused
      refuse(lateness.apply(order));
    }
    if (!PLANNING.contains(order.action()) || order.now()) {
      refuse(run.objection());
    }
    return switch (order.action()) {
      case GOTO -> goTo(known(run.progress().pursued(), order.uid().orElse("")));
      case SKIP -> skip(order);
      case INSERT -> insert(order);
      case UPDATE -> update(order);
      case RESUME -> resumable.resume();
      case PAUSE -> pause();
      case REPLACE -> replace(order);
      case LAND -> land();
      case RETURN -> goHome();
    };
  }

  private static void refuse(Optional<String> reason) {
    if (reason.isPresent()) {
      throw new BadInputException(reason.get());
    }
  }

  private String goTo(String uid) {
    run.progress().changeTo(uid);
    return "pursuing goal \"" + uid + "\"";
  }

  private String pause() {
    MissionProgress progress = run.progress();
    if (progress.mission().isOver()) {
      throw new BadInputException("the mission is over: nothing to pause");
    }
    boolean already = progress.isPaused();
    progress.pause(true);
    String where = (already ? "already paused at " : "paused at ") + currentOf(progress.mission());
    return where + afterFailsafe();
  }

  private String afterFailsafe() {
    MissionProgress progress = run.progress();
    return progress.isLeft() ? "; the failsafe " + progress.pursuedFor() + " is pursued first" : "";
  }

  private String skip(MissionOrder order) {
    GoalSequence pursued = run.progress().pursued();
    String uid =
        order
            .uid()
            .map(name -> known(pursued, name))
            .orElseGet(() -> only(pursued, ": no goal to skip", "the name of one of "));
    String reason = "skipped by " + order.operator();
    boolean skipped =
        run.progress().finish(uid, GoalResult.SKIPPED, Optional.empty(), reason, run.micros());
    if (!skipped) {
      throw new BadInputException(
          "goal \"" + uid + "\" is not current; current: " + currentOf(pursued));
    }
    return "goal \"" + uid + "\" skipped; current: " + currentOf(pursued);
  }

  private static String only(GoalSequence sequence, String ifOver, String ifSeveral) {
    Set<String> current = sequence.currentNames();
    if (current.size() != 1) {
      throw new BadInputException(
          current.isEmpty()
              ? "the mission is over" + ifOver
              : "several goals are current; expected " + ifSeveral + currentOf(sequence));
    }
    return current.iterator().next();
  }

  private String insert(MissionOrder order) {
    GoalSequence mission = run.progress().mission();
    List<GoalInformation> goals = reader().readAdded(root(order), mission.book);
    checkRoom(mission, goals);
    GoalInsertion insertion = new GoalInsertion(mission, goals);
    if (order.now()) {
      if (mission.isInTheMiddleOfOptions()) {
        throw new BadInputException(
            "some of several options are finished, others not; expected insertion after a goal");
      }
      String then = currentOf(mission);
      insertion.now();
      MissionProgress progress = run.progress();
      progress.pause(progress.isPaused() && progress.isLeft());
      return "pursuing " + insertion.names() + ", then " + then + afterFailsafe();
    }
    String after =
        order
            .uid()
            .map(name -> known(mission, name))
            .orElseGet(
                () -> only(mission, "; expected goals to be pursued now", "after which of "));
    if (!mission.followers.reachable(mission.currentNames()).contains(after)) {
      throw new BadInputException(
          String.format(
              "goal \"%s\" is not a successor of a current goal, so nothing after it would be "
                  + "reached;"
                  + " current: %s; expected one of what follows, or insertion now",
              after, currentOf(mission)));
    }
    return "inserted "
        + insertion.names()
        + insertion.after(after).stream()
            .map(each -> "\"" + each + "\"")
            .collect(Collectors.joining(", ", " after ", ""));
  }

  private String update(MissionOrder order) {
    GoalSequence mission = run.progress().mission();
    List<GoalInformation> changes = reader().readChanged(root(order), mission.book);
    checkRoom(mission, changes);
    changes.forEach(mission::update);
    return "updated "
        + changes.stream().map(each -> "\"" + each.uid() + "\"").collect(Collectors.joining(", "));
  }

  private String replace(MissionOrder order) {
    Mission mission = reader().read(root(order));
    if (!new GoalBook(List.of()).hasRoomForUpdates(mission.goals())) {
      throw new BadInputException("the mission's goals would be too long to publish");
    }
    replacement.accept(mission);
    run.progress().pause(!order.now());
    return (order.now() ? "pursuing " : "paused at ")
        + currentOf(run.progress().mission())
        + afterFailsafe();
  }

  private String land() {
    List<GoalInformation> goals = landing.get();
    if (goals.isEmpty()) {
      throw new BadInputException(
          "the Mission Manager has no LAND MISSION, and the mission no landingStart");
    }
    return leaveFor(goals);
  }

  private String goHome() {
    Waypoint place =
        returning
            .get()
            .orElseThrow(
                () ->
                    new BadInputException("the mission has no home, and there is no rally point"));
    GoalSequence mission = run.progress().mission();
    boolean isGoal = mission.knows(place.uid()) && place.uid().equals(Home.NAME);
    List<Waypoint> route =
        new ArrayList<>(
            way.apply(place)
                .orElseThrow(
                    () -> new BadInputException("the fence leaves no way to " + place.uid())));
    if (isGoal && !run.progress().isLeft() && route.isEmpty()) {
      return goTo(place.uid());
    }
    route.add(place);
    return leaveFor(route.stream().map(FailsafeMissions::returning).collect(Collectors.toList()));
  }

  /** Pursues other goals, the last of which ends the mission. */
  private String leaveFor(List<GoalInformation> goals) {
    if (run.progress().isLeft()) {
      throw new BadInputException("the failsafe " + run.progress().pursuedFor() + " is pursued");
    }
    GoalSequence mission = run.progress().mission();
    checkRoom(mission, goals);
    return goTo(new GoalInsertion(mission, goals).toTheEnd());
  }

  private static void checkRoom(GoalSequence mission, List<GoalInformation> goals) {
    if (!mission.book.hasRoomForUpdates(goals)) {
      throw new BadInputException("the mission's goals would be too long to publish");
    }
  }

  private MissionReader reader() {
    return new MissionReader(types, OptionalDouble.of(run.thresholdM()));
  }

  private static XmlElement root(MissionOrder order) {
    byte[] text =
        order
            .goals()
            .orElseThrow(() -> new BadInputException("no goals; expected a mission in XML"))
            .getBytes(StandardCharsets.UTF_8);
    return XmlReader.read(
        new ByteArrayInputStream(text), order.file().orElse("the order"), "mission");
  }

  private static String known(GoalSequence sequence, String uid) {
    if (!sequence.knows(uid)) {
      List<String> names = sequence.book.names();
      throw new BadInputException(
          String.format(
              "no goal \"%s\"; expected one of %s%s",
              uid, String.join(", ", names), NearestNames.didYouMean(uid, names)));
    }
    return uid;
  }

  private static String currentOf(GoalSequence sequence) {
    return sequence.isOver()
        ? "none, the mission is over"
        : String.join(", ", sequence.currentNames());
  }
}
