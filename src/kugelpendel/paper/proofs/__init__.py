"""How a step is proved: symbolically, and with numbers in worlds where its conditions hold."""
