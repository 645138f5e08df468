/**
 * Flights over hosts that are network namespaces of this machine: cut links, killed brokers, hosts
 * that vanish, latency and loss. How a single connection breaks is tested beside its class.
 */
package org.u2sa.network;
