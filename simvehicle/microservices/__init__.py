"""What the vehicle does with each MAVLink message: one module per microservice, each with its tables."""
