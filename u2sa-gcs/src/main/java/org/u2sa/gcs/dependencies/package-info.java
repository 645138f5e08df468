/**
 * The command that lists the libraries U2SA is made with, their age and the advisories published on
 * them, from two dated files in the jar. Nothing is asked over the network.
 */
package org.u2sa.gcs.dependencies;
