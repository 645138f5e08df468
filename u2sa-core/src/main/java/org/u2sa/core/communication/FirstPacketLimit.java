package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.util.ReferenceCountUtil;

/**
 * Bounds what a client may send before its first packet is whole, which would be kept until then.
 * Belongs to its connection's thread.
 */
final class FirstPacketLimit extends ChannelInboundHandlerAdapter {
  private final ClientSession session;
  private long bytes;

  FirstPacketLimit(ClientSession session) {
    this.session = session;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    bytes += ((ByteBuf) message).readableBytes();
    if (!session.isPending()) {
      ctx.fireChannelRead(message);
      ctx.pipeline().remove(this);
    } else if (bytes > BrokerLimits.FIRST_PACKET_BYTES) {
      ReferenceCountUtil.release(message);
      session.putOutFor("connection closed, its first packet is too long");
    } else {
      ctx.fireChannelRead(message);
    }
  }
}
