package org.u2sa.trials.run;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Orders the scheduled service swaps. In and out: service-orders. */
public final class SwapOperator extends PeriodicService {
  private static final double LOOKS_PER_S = 10.0;
  private static final String NAME = "SwapOperator";

  private final Queue<PlannedSwap> due =
      new ConcurrentLinkedQueue<>(); // read by other threads after the end
  private final Consumer<String> console;
  private final double beganS;
  private final List<String> refusals = new CopyOnWriteArrayList<>(); // as due

  /**
   * @param console receives one line per swap with its result
   */
  public SwapOperator(ServiceContext context, List<PlannedSwap> swaps, Consumer<String> console) {
    super(context, ServiceRole.OBSERVER, NAME, LOOKS_PER_S);
    this.console = console;
    beganS = nowS();
    swaps.stream().sorted(Comparator.comparingDouble(PlannedSwap::atS)).forEach(due::add);
    registerPublisher(Channels.SERVICE_ORDERS);
    registerSubscriber(Channels.SERVICE_ORDERS);
  }

  @Override
  protected void step(double nowS) {
    while (!due.isEmpty() && nowS - beganS >= due.peek().atS()) {
      PlannedSwap swap = due.remove();
      publish(
          Channels.SERVICE_ORDERS,
          new ServiceOrder()
              .requestId(NAME + " " + due.size())
              .serviceName(swap.service())
              .action(ServiceAction.SWAP)
              .className(swap.className())
              .operator("demo"));
    }
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof ServiceOrderResult result && result.requestId().startsWith(NAME)) {
      String what =
          String.format(
              Locale.ROOT,
              "%.1f s: %s %s",
              nowS() - beganS,
              result.serviceName(),
              result.accepted() ? "swapped" : "not swapped: " + result.reason());
      console.accept(what);
      if (!result.accepted()) {
        refusals.add(what);
      }
    }
  }

  /** Reports, after the run, the swaps whose time was not reached. */
  void tellMissed() {
    double endedS = nowS() - beganS;
    for (PlannedSwap missed : due) {
      console.accept(
          String.format(
              Locale.ROOT, "--swap %s had no effect: the run ended after %.1f s", missed, endedS));
    }
  }

  /** The rejected swaps and the reasons. */
  public List<String> refusals() {
    return List.copyOf(refusals);
  }

  /**
   * A scheduled swap of a service.
   *
   * @param atS time since the services were started [s]
   * @param service name of the service
   * @param className fully qualified name of the replacement class
   */
  public record PlannedSwap(double atS, String service, String className) {
    private static final Pattern FORM = Pattern.compile("([0-9]+(?:\\.[0-9]+)?):([^=]+)=(\\S+)");

    /**
     * Reads {@code SECONDS:SERVICE=CLASS}.
     *
     * @throws IllegalArgumentException if the text does not have that form
     */
    public static PlannedSwap parse(String text) {
      Matcher form = FORM.matcher(text);
      if (!form.matches()) {
        throw new IllegalArgumentException(
            "\""
                + text
                + "\" is not a swap; expected SECONDS:SERVICE=CLASS, such as"
                + " 100:PathPlanner=org.u2sa.planning.VectorFieldPlanner");
      }
      return new PlannedSwap(Double.parseDouble(form.group(1)), form.group(2), form.group(3));
    }

    /**
     * Rejects swaps to classes that are not services; called before the run.
     *
     * @throws BadInputException naming the class
     */
    static void requireClasses(List<PlannedSwap> swaps, LaunchOptions options) {
      for (PlannedSwap swap : swaps) {
        try {
          options.requireServiceClass(swap.className);
        } catch (BadInputException e) {
          throw new BadInputException("--swap " + swap + ": " + e.getMessage(), e);
        }
      }
    }

    /**
     * Rejects swaps of services that are not running, because the order would be ignored.
     *
     * @param running names of the running services
     * @throws BadInputException listing the services and the closest match
     */
    static void requireServices(List<PlannedSwap> swaps, List<String> running) {
      for (PlannedSwap swap : swaps) {
        if (!running.contains(swap.service)) {
          throw new BadInputException(
              "--swap "
                  + swap
                  + ": no service \""
                  + swap.service
                  + "\" is running; expected one of "
                  + String.join(", ", running)
                  + NearestNames.didYouMean(swap.service, running));
        }
      }
    }

    /** The swap as entered. */
    @Override
    public String toString() {
      return atS + ":" + service + "=" + className;
    }
  }
}
