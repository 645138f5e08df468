/**
 * What a system publishes, or has published, for viewers that speak the Foxglove WebSocket protocol
 * (github.com/foxglove/ws-protocol, v1): Foxglove, Lichtblick. Read-only: nothing that a viewer
 * sends reaches a service. Netty stops here.
 */
package org.u2sa.gcs.view;
