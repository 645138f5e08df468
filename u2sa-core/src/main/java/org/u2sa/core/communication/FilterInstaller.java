package org.u2sa.core.communication;

import static java.util.concurrent.TimeUnit.SECONDS;

import io.moquette.broker.Server;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandler;
import io.netty.channel.EventLoop;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.ServerChannel;
import io.netty.channel.SingleThreadEventLoop;
import io.netty.util.concurrent.EventExecutor;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.ExecutionException;
import org.u2sa.interfaces.communication.CommunicationException;

/**
 * Installs the connection filter before Moquette's listening socket. Moquette has no API for that,
 * so a private field is read; if a later version moves it, the broker refuses to start. Connections
 * made before the filter is installed are rejected and closed, because nothing would limit what
 * Moquette decodes for them.
 */
final class FilterInstaller {
  private static final long END_WITHIN_S = 5;

  private FilterInstaller() {}

  static void install(ConnectionFilter filter, Server server) {
    int installed = 0;
    try {
      Object acceptor = field(server, "acceptor");
      EventLoopGroup listening = (EventLoopGroup) field(acceptor, "bossGroup");
      EventLoopGroup workers = (EventLoopGroup) field(acceptor, "workerGroup");
      EventLoop one = workers.next();
      filter.broker.router.runOn(one);
      for (EventExecutor executor : listening) {
        installed += executor.submit(() -> install(filter, (EventLoop) executor, one)).get();
      }
      listening.next().scheduleAtFixedRate(filter::tidy, 1, 1, SECONDS);
      for (EventExecutor executor : workers) {
        executor.submit(() -> closeUnfiltered((SingleThreadEventLoop) executor)).get();
      }
    } catch (ReflectiveOperationException | ExecutionException e) {
      throw new CommunicationException("this version of Moquette cannot be secured: " + e, e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CommunicationException("interrupted while the broker started", e);
    }
    if (installed == 0) {
      throw new CommunicationException("this version of Moquette cannot be secured: no socket");
    }
  }

  /**
   * Ends the network threads. Moquette would also do this, but only after two idle seconds,
   * although everything has been sent.
   */
  static void takeDown(Server server) {
    try {
      Object acceptor = field(server, "acceptor");
      if (acceptor == null) {
        return; // failed before its threads were created
      }
      for (String group : List.of("bossGroup", "workerGroup")) {
        ((EventLoopGroup) field(acceptor, group)).shutdownGracefully(0, END_WITHIN_S, SECONDS);
      }
    } catch (ReflectiveOperationException e) {
      throw new CommunicationException("this version of Moquette cannot be secured: " + e, e);
    }
  }

  private static Object field(Object owner, String name) throws ReflectiveOperationException {
    Field field = owner.getClass().getDeclaredField(name);
    field.setAccessible(true);
    return field.get(owner);
  }

  /**
   * Serves all connections on one thread, so that messages between them never change threads:
   * waking another thread takes longer than routing a message. Netty would use several.
   */
  private static void putOnThread(EventLoop one, Channel listening)
      throws ReflectiveOperationException {
    ChannelHandler acceptor = listening.pipeline().last();
    Field group = acceptor.getClass().getDeclaredField("childGroup");
    group.setAccessible(true);
    group.set(acceptor, one);
  }

  /** Closes connections made before the filter was installed. Call on the loop's thread. */
  private static void closeUnfiltered(SingleThreadEventLoop loop) {
    List<Channel> unfiltered = new ArrayList<>();
    loop.registeredChannelsIterator()
        .forEachRemaining(
            channel -> {
              if (!channel.hasAttr(ConnectionFilter.FILTERED)) {
                unfiltered.add(channel);
              }
            });
    unfiltered.forEach(Channel::close);
  }

  /** Call on the loop's thread, the only one that may access its channels. */
  private static int install(ConnectionFilter filter, EventLoop loop, EventLoop one)
      throws ReflectiveOperationException {
    int installed = 0;
    Iterator<Channel> channels = ((SingleThreadEventLoop) loop).registeredChannelsIterator();
    while (channels.hasNext()) {
      Channel channel = channels.next();
      if (channel instanceof ServerChannel) {
        putOnThread(one, channel);
        channel.pipeline().addFirst(filter.acceptor(channel.localAddress()));
        installed++;
      }
    }
    return installed;
  }
}
