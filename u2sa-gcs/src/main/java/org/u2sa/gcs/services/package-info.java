/**
 * Commands with which an operator sees the services of a running system, finds them by their data,
 * and stops, restarts and swaps them. How a system is joined belongs to the remote package.
 */
package org.u2sa.gcs.services;
