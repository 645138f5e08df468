package org.u2sa.interfaces.communication;

import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.eclipse.paho.client.mqttv3.MqttPingSender;
import org.eclipse.paho.client.mqttv3.internal.ClientComms;

/**
 * Has Paho look after the link at regular times, on the connection's own thread. Paho's own senders
 * keep the program alive, or interrupt the thread that found the link dead.
 */
final class KeepAlive implements MqttPingSender {
  private final ScheduledExecutorService thread;
  private ClientComms link;
  private Future<?> next;
  private boolean stopped;

  KeepAlive(ScheduledExecutorService thread) {
    this.thread = thread;
  }

  @Override
  public synchronized void init(ClientComms comms) {
    link = comms;
  }

  @Override
  public void start() {
    schedule(link.getKeepAlive());
  }

  @Override
  public synchronized void stop() {
    stopped = true;
    if (next != null) {
      next.cancel(false);
    }
  }

  @Override
  public synchronized void schedule(long delayMs) {
    if (stopped) {
      return;
    }
    try {
      next = thread.schedule((Runnable) link::checkForActivity, delayMs, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      stopped = true; // the connection is being closed, and its thread with it
    }
  }
}
