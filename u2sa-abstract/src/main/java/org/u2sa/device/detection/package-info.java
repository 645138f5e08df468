/** Sensors that recognise objects themselves, such as cameras with a neural network. */
package org.u2sa.device.detection;
