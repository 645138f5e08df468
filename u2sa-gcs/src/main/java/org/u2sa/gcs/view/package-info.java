/**
 * Serves a running system or a recording to viewers with the Foxglove WebSocket protocol
 * (github.com/foxglove/ws-protocol, v1): Foxglove, Lichtblick. Read-only: nothing that a viewer
 * sends reaches a service.
 */
package org.u2sa.gcs.view;
