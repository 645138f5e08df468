package org.u2sa.core.safety;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.AnsweredOrders;

/**
 * Executes operators' fence orders and reports the results. Idempotent: a repeated order is
 * answered again but not executed again.
 */
final class FenceOrders {
  private static final String ANSWERED = "ANSWERED FENCE ORDERS";

  private final FenceWatch watch;
  private final Function<FenceOrder, Optional<String>> lateness;
  private final AnsweredOrders<FenceOrderResult> answered = new AnsweredOrders<>();

  /**
   * @param lateness reason for refusing an order that arrived too late
   */
  FenceOrders(FenceWatch watch, Function<FenceOrder, Optional<String>> lateness) {
    this.watch = watch;
    this.lateness = lateness;
  }

  /**
   * Executes an order unless already done. Returns the answer in the name of the manager.
   *
   * @param armed whether the vehicle is armed: it must then be well inside the new fence
   */
  FenceOrderResult obey(FenceOrder order, String manager, boolean armed, long nowMicros) {
    Optional<FenceOrderResult> before = answered.to(order.requestId(), order);
    if (before.isPresent()) {
      return before.get();
    }
    FenceOrderResult result =
        new FenceOrderResult().requestId(order.requestId()).serviceName(manager);
    try {
      lateness
          .apply(order)
          .ifPresent(
              reason -> {
                throw new BadInputException(reason);
              });
      result.accepted(true).outcome(outcome(order, armed, nowMicros));
    } catch (BadInputException e) {
      result.accepted(false).outcome(e.getMessage());
    }
    answered.remember(order.requestId(), order, result);
    return result;
  }

  void handOver(HandOver state) {
    answered.handOver(state, ANSWERED);
  }

  void takeOver(HandOver state) {
    answered.takeOver(state, ANSWERED, FenceOrderResult.class);
  }

  private String outcome(FenceOrder order, boolean armed, long nowMicros) {
    switch (order.action()) {
      case REPLACE:
        GivenFence given = watch.given(source(order), text(order));
        check(given, armed, nowMicros);
        checkNewRallyPoints(given);
        watch.order(Optional.of(given));
        return "fence of " + given.file() + " in force" + remark(nowMicros);
      case RELOAD:
        Optional<GivenFence> configured = watch.configured();
        configured.ifPresent(fence -> check(fence, armed, nowMicros));
        watch.load();
        return configured.isPresent()
            ? "fence of " + configured.get().file() + " in force" + remark(nowMicros)
            : "no fence is configured: none in force";
      default:
        watch.order(Optional.empty());
        return "no fence in force";
    }
  }

  private static String source(FenceOrder order) {
    return order.file().orElse("an order by " + order.operator());
  }

  private static String text(FenceOrder order) {
    return order.fence().orElseThrow(() -> new BadInputException("no fence; expected one in XML"));
  }

  private String straight() {
    FenceState published = watch.state();
    boolean leads = !published.keepIn().isEmpty() || !published.keepOut().isEmpty();
    boolean isEmpty = watch.fence().filter(Fence::hasAreas).isEmpty();
    return leads || isEmpty ? "" : "; too many corners to lead around: returns are straight";
  }

  private String unused() {
    String points =
        watch.fence().stream()
            .flatMap(
                fence -> fence.rally().stream().filter(each -> fence.objection(each).isPresent()))
            .map(Fence.RallyPoint::name)
            .collect(Collectors.joining(", "));
    return points.isEmpty() ? "" : "; outside it, so unused: " + points;
  }

  private void check(GivenFence given, boolean armed, long nowMicros) {
    if (armed) {
      watch
          .refusal(given, nowMicros)
          .ifPresent(
              words -> {
                throw new BadInputException(
                    given.file() + ": the vehicle is armed and violates it: " + words);
              });
    }
  }

  /** Positions of the previous fence may be outside: the vehicle just does not use them. */
  private void checkNewRallyPoints(GivenFence given) {
    List<Fence.RallyPoint> before = watch.fence().map(Fence::rally).orElse(List.of());
    for (Fence.RallyPoint point : given.fence().rally()) {
      Optional<String> objection =
          given.fence().objection(point).filter(words -> before.stream().noneMatch(point::isAt));
      if (objection.isPresent()) {
        throw new BadInputException(given.file() + ": " + point + ": " + objection.get());
      }
    }
  }

  private String remark(long nowMicros) {
    return unused()
        + straight()
        + watch.objection(nowMicros).map(words -> "; arming is not possible: " + words).orElse("");
  }
}
