package org.u2sa.service.inbox;

import java.util.Optional;
import java.util.function.Consumer;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * The newest orders of the service contract, which a service knows across its restarts: to stop,
 * and to change variables, the latter with their answers. A broker may deliver an order twice (QoS
 * 1), the second time to the restarted service. Thread-safe.
 */
public final class ContractOrders {
  private static final String STOPS = "ORDERS TO STOP";
  private static final String CHANGES = "CHANGES OF VARIABLES";

  private final Consumer<HandOver> saver;
  private final ObeyedOrders stops = new ObeyedOrders(); // guarded by this
  private final AnsweredOrders<U2SAData> changes = new AnsweredOrders<>(); // guarded by this

  /**
   * @param saver saves them for a successor; called after each new order
   */
  public ContractOrders(Consumer<HandOver> saver) {
    this.saver = saver;
  }

  /**
   * Whether an order to stop is to be obeyed; remembers it. One to all services ends the run, and
   * its services are not restarted.
   */
  public synchronized boolean isNew(StopCommand stop) {
    if (stop.stopAll()) {
      return true;
    }
    boolean isNew = stops.add("", stop);
    if (isNew && stop.timestamp().isPresent()) {
      save();
    }
    return isNew;
  }

  /** Answer to a change of variables; empty if it was not answered yet. */
  public synchronized Optional<U2SAData> answer(String requestId, U2SAData change) {
    return changes.to(requestId, change);
  }

  /** Remembers the answer to a change of variables. */
  public synchronized void remember(String requestId, U2SAData change, U2SAData answer) {
    changes.remember(requestId, change, answer);
    save();
  }

  private void save() {
    HandOver state = new HandOver(ContractOrders.class.getName());
    changes.handOver(state, CHANGES);
    saver.accept(state.texts(STOPS, stops.identities()));
  }

  /** Knows what a predecessor obeyed and answered. */
  public synchronized void takeOver(HandOver state) {
    stops.takeOver(state.texts(STOPS));
    changes.takeOver(state, CHANGES, U2SAData.class);
  }
}
