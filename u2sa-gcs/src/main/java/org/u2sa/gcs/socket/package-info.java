/**
 * WebSocket servers for programs and pages of other projects: handshake, limits, encryption, and
 * which web pages may connect. The conversation itself belongs to the packages that use it. Netty
 * is confined to this package.
 */
package org.u2sa.gcs.socket;
