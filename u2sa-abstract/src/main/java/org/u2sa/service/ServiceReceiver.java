package org.u2sa.service;

import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.U2SAData;

/**
 * Sorts what the transport brings: orders to stop are obeyed at once, what concerns the service
 * waits in its inbox. Called on the transport's or another service's thread, so nothing here waits.
 */
final class ServiceReceiver implements Receiver {
  private final U2SAService service;

  ServiceReceiver(U2SAService service) {
    this.service = service;
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (service.contract().isOrderToStop(message)) {
      service.askToStop();
    } else if (service.wiring().isSubscribed(channel) || service.contract().concerns(message)) {
      ServiceInbox inbox = service.inbox();
      if (!inbox.put(channel, message) && Long.bitCount(inbox.dropped()) == 1) {
        service.log(
            LogLevelEnum.WARN, "inbox full: " + inbox.dropped() + " messages dropped so far");
      }
      service.wake();
    }
  }

  @Override
  public void trouble(String what) {
    service.log(LogLevelEnum.WARN, what);
  }
}
