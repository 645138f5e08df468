/**
 * WebSocket servers for programs and pages of other projects: handshake, limits, encryption, and
 * which web pages may connect. What clients and server say to each other belongs to the packages
 * that use it. Netty is confined to this package.
 */
package org.u2sa.gcs.socket;
