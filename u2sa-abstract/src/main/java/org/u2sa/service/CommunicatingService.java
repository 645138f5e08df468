package org.u2sa.service;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Communicator;
import org.u2sa.interfaces.communication.Publisher;
import org.u2sa.interfaces.communication.Subscriber;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/** The part of a service that registers, publishes and subscribes (thesis 3.2.1.2–3.2.1.4). */
abstract class CommunicatingService extends ConfiguredService
    implements Communicator, Publisher, Subscriber {
  private final ServiceWiring wiring;

  CommunicatingService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, serviceName);
    wiring = new ServiceWiring(context, role, getServiceName(), receiver());
    context.onAbandon(wiring::close);
  }

  /** What the transport calls with messages; asked for once, while this is being constructed. */
  abstract ServiceReceiver receiver();

  final ServiceWiring wiring() {
    return wiring;
  }

  @Override
  public final boolean beginCommunication() {
    return attempt("connecting", wiring::isReady);
  }

  @Override
  public final boolean registerPublisher(Class<? extends U2SAData> dataType) {
    return onChannelToPublish(dataType, this::registerPublisher);
  }

  /** {@link #registerPublisher(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerPublisher(String channelName) {
    return onChannelNamed(channelName, this::registerPublisher);
  }

  /** {@link #registerPublisher(Class)} on a channel. */
  public final boolean registerPublisher(Channel<?> channel) {
    return attempt(
        "registering as publisher of " + channel, () -> wiring.registerPublisher(channel));
  }

  @Override
  public final boolean unregisterPublisher(Class<? extends U2SAData> dataType) {
    return onChannelToPublish(dataType, wiring::unregisterPublisher);
  }

  @Override
  public final boolean registerSubscriber(Class<? extends U2SAData> dataType) {
    return onChannelToSubscribe(dataType, this::registerSubscriber);
  }

  /** {@link #registerSubscriber(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerSubscriber(String channelName) {
    return onChannelNamed(channelName, this::registerSubscriber);
  }

  /** {@link #registerSubscriber(Class)} on a channel. */
  public final boolean registerSubscriber(Channel<?> channel) {
    return attempt(
        "registering as subscriber of " + channel, () -> wiring.registerSubscriber(channel));
  }

  /**
   * {@link #registerSubscriber(Channel)} with a deadline: a message that is older when its turn
   * comes, or that does not say its time, counts as absent. It is not handed to the callback, but
   * counted as expired in health. A further call sets another deadline.
   *
   * @param deadlineS age at which a message counts as absent [s], positive
   */
  public final boolean registerSubscriber(Channel<?> channel, double deadlineS) {
    wiring.registrations().deadline(channel, Clock.micros(deadlineS));
    return registerSubscriber(channel);
  }

  @Override
  public final boolean unregisterSubscriber(Class<? extends U2SAData> dataType) {
    return onChannelToSubscribe(
        dataType,
        channel ->
            attempt("unregistering from " + channel, () -> wiring.unregisterSubscriber(channel)));
  }

  @Override
  public final boolean publish(U2SAData data) {
    Optional<Channel<?>> channel = wiring.registrations().channelFor(data);
    if (channel.isEmpty()) {
      log(
          LogLevelEnum.ERROR,
          "not registered as a publisher of " + data.type().name() + ": not published");
      return false;
    }
    return publish(channel.get(), data);
  }

  /** Publishes on the channel of that name (thesis 8.2.3.1). */
  public final boolean publish(String channelName, U2SAData data) {
    return onChannelNamed(channelName, channel -> publish(channel, data));
  }

  /**
   * Publishes on a channel. Missing system ID and timestamp are filled in; the message is frozen.
   */
  public final boolean publish(Channel<?> channel, U2SAData data) {
    if (wiring.isSilent()) {
      return false; // the successor speaks for this service now
    }
    if (!data.isFrozen()) {
      if (data.systemId().isEmpty()) {
        data.systemId(context().systemId());
      }
      if (data.timestamp().isEmpty()) {
        data.timestamp(clock().micros());
      }
      data.freeze();
    }
    try {
      if (wiring.publish(channel, data)) {
        return true;
      }
      if (Long.bitCount(wiring.refused()) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        log(LogLevelEnum.ERROR, "publishing on " + channel + " was refused: " + data);
      }
    } catch (CommunicationException e) {
      log(LogLevelEnum.ERROR, "publishing on " + channel + " failed: " + e.getMessage());
    }
    return false;
  }

  private boolean onChannelToPublish(
      Class<? extends U2SAData> dataType, Predicate<Channel<?>> action) {
    Registrations registrations = wiring.registrations();
    return registrations
        .channelToPublish(dataType)
        .map(action::test)
        .orElseGet(() -> refuse(registrations.noStandardChannel("publishes", dataType)));
  }

  private boolean onChannelToSubscribe(
      Class<? extends U2SAData> dataType, Predicate<Channel<?>> action) {
    Registrations registrations = wiring.registrations();
    return registrations
        .channelToSubscribe(dataType)
        .map(action::test)
        .orElseGet(() -> refuse(registrations.noStandardChannel("receives", dataType)));
  }

  private boolean onChannelNamed(String channelName, Predicate<Channel<?>> action) {
    Channel<?> channel;
    try {
      channel = Channels.namedOrNew(channelName);
    } catch (IllegalArgumentException e) {
      return refuse(e.getMessage());
    }
    return action.test(channel);
  }

  private boolean refuse(String why) {
    log(LogLevelEnum.ERROR, why);
    return false;
  }

  private boolean attempt(String what, BooleanSupplier action) {
    try {
      if (action.getAsBoolean()) {
        return true;
      }
      log(LogLevelEnum.ERROR, what + " was refused");
    } catch (CommunicationException e) {
      log(LogLevelEnum.ERROR, what + " failed: " + e.getMessage());
    }
    return false;
  }
}
